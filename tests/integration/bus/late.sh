# A recorder that comes late learns the job within a second, and says what it missed.
. "$(dirname "$0")/common.sh"
"$bin/exk-loop" "$profiles/rectangle.ini" --url="$url" -q >/dev/null 2>&1 &
loop=$!
children="$children $loop"
sleep 0.6
recorder late.lcm
sleep 1.4
kill -INT "$started"
ends "$started" 0
grep -Eq "exk-log: joined late: [1-9][0-9]+ samples were sent before the first one here" exk-log.err ||
    { cat exk-log.err; fail "not said that it joined late"; }
expect_part exk-log.out "late.lcm: rectangle, run 1 of series 0, 4 holes, dt 0.001 s"
[ "$(count lost exk-log.out)" -eq 0 ] || fail "what was sent before counts as lost"
kill -INT "$loop"
wait "$loop"

# two runs on one bus: the first is counted, the other named, both are in the log
short p.ini
recorder two.lcm
expect_code 0 "$bin/exk-loop" p.ini --url="$url" -r first.lcm
expect_code 0 "$bin/exk-loop" p.ini --url="$url" -r second.lcm
sleep 0.2
kill -INT "$started"
ends "$started" 0
grep -q "messages\? of other runs not counted" exk-log.err || fail "the second run is not said"
id() { "$bin/exk-log" --from "$1" --json | sed -n 's/.*"run_id": \(-*[0-9]*\),/\1/p'; }
for name in first second; do
    expect_code 0 "$bin/exk-log" --from $name.lcm --csv $name.csv
    expect_code 0 "$bin/exk-log" --from two.lcm --run-id="$(id $name.lcm)" --csv of_two.csv
    cmp $name.csv of_two.csv || fail "--run-id does not give the $name run"
    rm of_two.csv
done
exit 0
