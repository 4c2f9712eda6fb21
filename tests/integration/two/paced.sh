# In real time beside a twin: the job is drilled, and what did not come in time is counted, not used. How
# often that is depends on the machine: no figure of time is tested.
. "$(dirname "$0")/common.sh"
short p.ini -e 's/^\[loop\]/[loop]\nsource = bus\nmissed_max = 100000\nbad_max = 100000/'
machine p.ini --url="$url"
# fifo_threads ID: how many of a process's threads run under SCHED_FIFO (field 41 of stat, 39 behind the name)
fifo_threads() { cat /proc/"$1"/task/*/stat | sed 's/.*) //' | awk '$39 == 1 {n++} END {print n + 0}'; }
twin=$started
start "$bin/exk-loop" p.ini --url="$url" -r run.lcm
loop=$started
for ((i = 0; i < 100; i++)); do
    grep -q "memory lock" exk-loop.err && break
    sleep 0.02
done
loop_fifo=$(fifo_threads "$loop")
twin_fifo=$(fifo_threads "$twin")
ends "$loop" 0
# every hop of an answer: LCM's thread and ours at both ends, the one that sends, the control thread; a
# sanitizer may have one of its own
if grep -q "exk-loop: FIFO" exk-loop.err && ! grep -q "FIFO refused" exk-loop.err; then
    [ "$loop_fifo" -ge 4 ] || fail "$loop_fifo threads of exk-loop have FIFO, not 4"
    [ "$twin_fifo" -ge 2 ] || fail "$twin_fifo threads of exk-twin have FIFO, not 2"
fi
expect_part exk-loop.out "4 of 4 holes drilled"
expect_part exk-loop.out "machine on the bus: "
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
