# Loss is counted to the last sample: a recorder with a tiny socket buffer, stopped for half a second.
. "$(dirname "$0")/common.sh"
url="$url&recv_buf_size=10000"
recorder lossy.lcm --until-done --json=lossy.json
log=$started
"$bin/exk-loop" "$profiles/rectangle.ini" --url="$url" >loop.out 2>&1 &
loop=$!
children="$children $loop"
sleep 0.7
kill -STOP "$log"
sleep 0.5
kill -CONT "$log"
sleep 0.3
kill -INT "$loop"
wait "$loop"
ends "$log" 1
grep -Eq " samples? lost before k " exk-log.err || fail "the gap is not said"
published=$(sed -n 's/.* \([0-9]*\) poses published.*/\1/p' loop.out)
samples=$(count samples exk-log.out)
lost=$(count lost exk-log.out)
[ "$lost" -gt 300 ] || { cat exk-log.out; fail "only $lost lost: the test lost its point"; }
[ "$((samples + lost))" -eq "$published" ] ||
    fail "$samples samples and $lost lost are not the $published published"
[ "$(count "missed ticks" exk-log.out)" -le "$(sed -n 's/.* \([0-9]*\) missed.*/\1/p' loop.out)" ] ||
    fail "loss is taken for missed ticks"
expect_part lossy.json "\"lost_samples\": $lost,"
# a log with gaps is told apart for ever
expect_code 1 "$bin/exk-log" --from lossy.lcm
[ "$(count lost out)" -eq "$lost" ] || fail "the log counts otherwise than the recording"
exit 0
