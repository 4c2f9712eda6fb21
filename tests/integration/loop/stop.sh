# SIGINT and SIGTERM end a real-time run cleanly: exit 1, whole log, said once.
. "$(dirname "$0")/common.sh"
for signal in INT TERM HUP; do
    "$bin/exk-loop" "$profiles/rectangle.ini" --no-bus -r $signal.lcm >out 2>err &
    pid=$!
    sleep 0.7
    kill -$signal $pid
    code=0
    wait $pid || code=$?
    [ $code -eq 1 ] || { cat out err >&2; fail "SIG$signal: exit code $code, not 1"; }
    expect_part err "; the log is complete"
    [ -e $signal.lcm.part ] && fail "a .part file is left"
    expect_code 0 "$bin/exk-log" --from $signal.lcm --csv $signal.csv
    [ "$(wc -l <$signal.csv)" -gt 200 ] || fail "SIG$signal: fewer than 200 samples in the log"
done
exit 0
