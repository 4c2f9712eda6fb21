# A recorder that is stopped, then killed: the controller goes on, loses nothing of its own, and says nothing.
. "$(dirname "$0")/../two/common.sh"
short p.ini -e 's/^\[loop\]/[loop]\nmissed_max = 100000/'
recorder stopped.lcm
log=$started
kill -STOP "$log"
expect_code 0 "$bin/exk-loop" p.ini --url="$url" -r own.lcm
expect_part out "0 dropped by the ring"
grep -q "exk:" err && fail "the controller complains of a recorder"
kill -KILL "$log"
wait "$log" 2>/dev/null
[ -e stopped.lcm ] && fail "a killed recording looks whole"
expect_code 0 "$bin/exk-log" --from own.lcm
exit 0
