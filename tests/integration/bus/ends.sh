# How a recording ends: by Ctrl-C, by time, by a run that dies, by a recorder that is killed.
. "$(dirname "$0")/common.sh"
short p.ini
half() { "$bin/exk-loop" "$profiles/rectangle.ini" --url="$url" -q >/dev/null 2>&1 & loop=$!; children="$children $loop"; }

# Ctrl-C in mid-run is a good end of a recording: whole log, exit 0
recorder int.lcm
half
sleep 0.6
kill -INT "$started"
ends "$started" 0
[ -e int.lcm ] || fail "no log after SIGINT"
[ "$(count lost exk-log.out)" -eq 0 ] || fail "lost samples at SIGINT"
expect_code 0 "$bin/exk-log" --from int.lcm

# the time is over before the run is done
expect_code 1 "$bin/exk-log" time.lcm --url="$url" --seconds 0.4 --until-done
expect_part err "exk-log: the time was over before the run was done"
expect_code 0 "$bin/exk-log" time.lcm --url="$url" --seconds 0.4

# a recorder that is killed leaves its part, and the part can be read
recorder killed.lcm
sleep 1.2
kill -9 "$started"
wait "$started" 2>/dev/null
[ -e killed.lcm ] && fail "a killed recording looks whole"
"$bin/exk-log" --from killed.lcm.part >out 2>err
[ "$(count samples out)" -gt 100 ] || { cat out err; fail "the part holds no samples"; }

# a run that dies without a word: five silent seconds, then said
kill -9 "$loop"
wait "$loop" 2>/dev/null
recorder silent.lcm --until-done
half
sleep 1
kill -9 "$loop"
wait "$loop" 2>/dev/null
ends "$started" 1
expect_part exk-log.err "exk-log: nothing was heard for 5 s before the run was done"
[ -e silent.lcm ] || fail "what was heard is not kept"

# nothing on the bus
expect_code 1 "$bin/exk-log" none.lcm --url="$url" --seconds 0.2
expect_part err "no EXK_POSE was heard: is exk-loop running, and on this URL? exk-doctor checks the way"
exit 0
