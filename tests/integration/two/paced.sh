# In real time beside a twin: the job is drilled, and what did not come in time is counted, not used. How
# often that is depends on the machine: no figure of time is tested.
. "$(dirname "$0")/common.sh"
short p.ini -e 's/^\[loop\]/[loop]\nsource = bus\nmissed_max = 100000\nbad_max = 100000/'
machine p.ini --url="$url"
expect_code 0 "$bin/exk-loop" p.ini --url="$url" -r run.lcm
expect_part out "4 of 4 holes drilled"
expect_part out "machine on the bus: "
expect_count run.lcm state = done
expect_count run.lcm foreign -eq 0
expect_count run.lcm repeated -eq 0
expect_count run.lcm reordered -eq 0
steps=$(status_of run.lcm steps)
bad=$(status_of run.lcm bad)
[ "$bad" -lt $((steps / 2)) ] || fail "$bad of $steps samples did not come in time"
grep -q "run .* ended: " exk-twin.err || { cat exk-twin.err >&2; fail "no bye"; }
answered=$(sed -n 's/.* ended: \([0-9]*\) ticks answered.*/\1/p' exk-twin.err)
[ "$answered" -eq "$steps" ] || fail "$answered ticks answered of $steps"
exit 0
