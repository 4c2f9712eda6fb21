# 100,000 datagrams of garbage: none obeyed, the run as if nothing had been. 5,000 well-formed commands that
# nobody allowed, replays among them: none obeyed, all counted. hostile.sh ... 7: the program hostile
. "$(dirname "$0")/../two/common.sh"
hostile=$7
expect_code 0 "$bin/exk-command" keygen op.key
sed -e 's/^dwell_s *=.*/dwell_s = 0.5/' -e 's/^width_mm *=.*/width_mm = 100/' -e 's/^height_mm *=.*/height_mm = 60/' \
    -e 's/^\[loop\]/[command]\nallow = yes\nkey_file = op.key\ntimeout_s = 0\n[loop]\nmissed_max = 100000/' \
    "$profiles/rectangle.ini" >p.ini

start "$bin/exk-loop" p.ini --url="$url" -r run.lcm
loop=$started
sleep 0.4
expect_code 0 "$hostile" garbage "$url" 100000
expect_text out "sent 100000"
kill -0 "$loop" || fail "the run was over before the garbage was"
ends "$loop" 0
expect_part exk-loop.out "4 of 4 holes drilled"
expect_count run.lcm taken -eq 0
expect_count run.lcm state = done
expect_count run.lcm bad -eq 0

start "$bin/exk-loop" p.ini --url="$url" -r run.lcm
loop=$started
sleep 0.4
expect_code 0 "$bin/exk-log" part.lcm --url="$url" --seconds 0.3 -q
run_id=$("$last_status" part.lcm | awk '$1 == "run_id" { print $2 }')
"$hostile" commands "$url" 5000 "$run_id" >hostile.out &
attack=$!
for ((i = 0; i < 100; i++)); do
    grep -q listening hostile.out && break
    sleep 0.02
done
expect_code 0 "$bin/exk-command" alive --key op.key --url="$url"
wait "$attack" || fail "the attack failed"
[ "$(awk '$1 == "replays" { print $2 }' hostile.out)" -eq 1000 ] || fail "no replays were tried"
kill -0 "$loop" || fail "the run was over before the attack was"
ends "$loop" 0
expect_part exk-loop.out "4 of 4 holes drilled"
expect_count run.lcm taken -eq 1
expect_count run.lcm other_run -eq 1000
expect_count run.lcm wrong_key -eq 3000
stale=$(status_of run.lcm stale)
replayed=$(status_of run.lcm replayed)
[ $((stale + replayed)) -eq 1000 ] || fail "of 1000 replays $stale were stale and $replayed replayed"
expect_count run.lcm malformed -eq 0
expect_count run.lcm state = done
exit 0
