# A profile with faults in it: what is said, published, kept, and not learned.
. "$(dirname "$0")/common.sh"
short p.ini
with() { cp p.ini "$1"; printf '\n[fault.1]\nkind = %s\nat_s = 0.5\nfor_s = %s\n' "$2" "$3" >>"$1"; }

# shorter than n = 20: counted, held, the job is done
with short.ini nan 0.010
expect_code 0 "$bin/exk-loop" short.ini --fast -r short.lcm
expect_part out "10 bad samples"
[ -e short.fault.lcm ] && fail "a capture of a run without a fault"
expect_code 2 "$bin/exk-ilc" learn short.lcm -o s.ilc
expect_part err "10 rejected sensor samples: nothing is learned"
[ -e s.ilc ] && fail "a store was learned from faulty samples"
expect_code 0 "$bin/exk-ilc" learn short.lcm -o s.ilc --allow-bad

# longer: a fault with cause, count, tick, hole and what to do; the samples before it beside the record
with long.ini dropout 0.100
expect_code 1 "$bin/exk-loop" long.ini --fast -r long.lcm
expect_part err "fault: rejected sensor samples in a row: 20, limit 20, the last one missing; tick 519, "
expect_part err "; check encoder and cable"
expect_part err "full rate: long.fault.lcm"
expect_code 0 "$bin/exk-log" --from long.fault.lcm --csv long.csv
[ "$(wc -l <long.csv)" -eq 521 ] || fail "the capture does not hold the 520 samples up to the fault"

# stopped before the way out of the part has begun: not told to be out of it
cp long.ini rest.ini
printf '\n[guard]\nretract_after_s = 3600\n' >>rest.ini
sed -i 's/^for_s = .*/for_s = 100000/' rest.ini
"$bin/exk-loop" rest.ini --fast --no-bus >out 2>err &
loop=$!
sleep 0.7
kill -INT "$loop"
wait "$loop" && fail "a run that a fault and a signal ended has exit code 0"
expect_part err "the tool had not begun its way out of the part"

# a series keeps what it learned before the run of which it learns nothing: a spike that only some noise shows
cp "$profiles/machine.ini" some.ini
printf '\n[fault.1]\nkind = spike\nchannel = alpha\nat_s = 1\nsize_mrad = 0.014\n' >>some.ini
expect_code 2 "$bin/exk-ilc" train some.ini -n 40 -o some.ilc
run=$(sed -n 's/^exk-ilc: run \([0-9]*\) had 1 rejected.*/\1/p' err)
[ "$run" -gt 1 ] || fail "nothing was learned before run $run"
expect_code 0 "$bin/exk-ilc" train some.ini -n $((run - 1)) -o before.ilc
cmp some.ilc before.ilc || fail "the store is not that of the runs before run $run"
expect_code 1 "$bin/exk-ilc" train long.ini -n 2
expect_part err "run 1 ended by fault: rejected sensor samples in a row: 20, limit 20"

# a limit: named with value, limit and the key to change; the same bytes again
cp p.ini limit.ini
printf '\n[limits]\nrate_radps = 0.05\n' >>limit.ini
expect_code 1 "$bin/exk-loop" limit.ini --fast -r a.lcm
expect_part err "fault: commanded angle rate of "
expect_part err "rad/s, limit 0.05 rad/s; tick "
expect_part err "or raise [limits] rate_radps"
expect_part err "the last good command was held"
expect_code 1 "$bin/exk-loop" limit.ini --fast -r b.lcm
cmp a.lcm b.lcm || fail "the same faulty run gives other bytes"
cmp a.fault.lcm b.fault.lcm || fail "the same fault gives other samples before it"
exit 0
