# Logs with something missing: what is said, and that figures with losses are no evidence.
. "$(dirname "$0")/common.sh"
run_log good "${quiet_machine[@]}"
n=$("$holes" good.lcm --json | sed -n 's/^  "n_samples": \([0-9]*\),$/\1/p')
[ "$n" -gt 1000 ] || fail "n_samples is $n"

edit good.lcm lossy.lcm lose=100-102
expect_code 1 "$holes" lossy.lcm
expect_text out "3 samples lost: figures are not evidence"
[ "$(grep -c 'not evidence' out)" -eq 2 ] || fail "not said at both ends of the table"
expect_part out "tolerance 0.03 mm; $((n - 3)) samples, 3 lost"
expect_part out "inside          4 of 4 = 100.0 %"
expect_code 1 "$holes" lossy.lcm --json
expect_text out '  "lost_samples": 3,'
expect_text out '  "evidence": false,'
expect_code 0 "$holes" lossy.lcm --report-only
edit good.lcm one.lcm lose=100-100
expect_code 1 "$holes" one.lcm
expect_text out "1 sample lost: figures are not evidence"

# the recording began late
edit good.lcm late.lcm lose=0-9
expect_code 1 "$holes" late.lcm
expect_text err "exk-holes: 10 samples before the first one here counted as lost"
expect_text out "10 samples lost: figures are not evidence"

# the last samples never came: the last status knows
edit good.lcm tail.lcm lose=$((n - 5))-$n
expect_code 1 "$holes" tail.lcm
expect_text out "5 samples lost: figures are not evidence"

# the run was cut: holes that were never reached are named, the rate is over all holes
k=$("$holes" good.lcm --csv - | sed -n 3p | cut -d, -f10)
edit good.lcm half.lcm until=$((k + 5))
expect_code 1 "$holes" half.lcm --csv half.csv
expect_text err "exk-holes: the log ends before the run was done (tick $((k + 6)) of $n)"
expect_text out "  never reached   2 holes: 3, 4"
expect_part out "inside          2 of 4 = 50.0 %"
expect_part half.csv ",,,,0,,"
expect_code 1 "$holes" half.lcm --json
expect_part out '"dx_mm": null'
expect_text out '  "complete": false,'

# cut inside the dwell: not drilled; right after its last sample: drilled
edit good.lcm dwell.lcm until=$((k - 1))
expect_code 1 "$holes" dwell.lcm
expect_text out "  never reached   3 holes: 2, 3, 4"
edit good.lcm end.lcm until="$k"
expect_code 1 "$holes" end.lcm
expect_text out "  never reached   2 holes: 3, 4"

# the sample before a stroke is lost: judged on an earlier one, and said
edit good.lcm early.lcm lose="$k-$k"
expect_code 1 "$holes" early.lcm
expect_part err "exk-holes: 1 of 4 holes judged on an earlier sample of the dwell: "

# a file cut inside a record: all whole records count
head -c $(($(stat -c %s good.lcm) / 2 + 100)) good.lcm >cut.lcm
expect_code 1 "$holes" cut.lcm
"$bin/exk-log" --from cut.lcm -q --csv cut.csv >/dev/null 2>&1
n_whole=$(($(wc -l <cut.csv) - 1))
expect_text err "exk-holes: the log ends inside a record: $n_whole whole samples judged"
expect_code 2 "$bin/exk-ilc" learn cut.lcm -o cut.ilc
expect_text err "exk-ilc: cut.lcm: $((n - n_whole)) of $n ticks are missing, at most 1 % are allowed: nothing is learned; record a whole run"
[ -e cut.ilc ] && fail "a store was learned from half a run"

# decimation is no loss: every tenth sample and the judged ones give the same holes
printf '\n[telemetry]\nevery = 10\n' >tail.txt
cat good.ini tail.txt >tenth.ini
"$bin/exk-loop" tenth.ini --fast -q -r tenth.lcm >/dev/null || fail "no log tenth.lcm"
expect_code 0 "$holes" tenth.lcm --csv tenth.csv
expect_part out ", 0 lost"
"$holes" good.lcm -q --csv good.csv >/dev/null
cmp good.csv tenth.csv || fail "a decimated log is judged otherwise"
exit 0
