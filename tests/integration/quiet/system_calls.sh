# The loop thread makes no system call but the sleep while it runs: read from a trace of that thread.
. "$(dirname "$0")/../loop/common.sh"
command -v strace >/dev/null || { echo "strace is not installed"; exit 77; }
strace -o /dev/null true 2>/dev/null || { echo "tracing is not allowed here"; exit 77; }
sed -e 's/^columns *=.*/columns = 2/' -e 's/^rows *=.*/rows = 1/' -e 's/^drill_mmps *=.*/drill_mmps = 50/' \
    -e 's/^width_mm *=.*/width_mm = 20/' -e 's/^dwell_s *=.*/dwell_s = 0.1/' \
    -e 's/^\[loop\]/[loop]\nmissed_max = 100000/' "$profiles/machine.ini" >p.ini
strace -ff -o trace "$bin/exk-loop" p.ini --no-bus -r run.lcm >out 2>err || fail "exk-loop ended with $?"
# the main thread's trace is the one that executes the program
main=$(grep -l '^execve' trace.*)
awk '/^clock_nanosleep/ {last = NR; if (!first) first = NR} END {print first, last}' "$main" >span
read -r first last <span
awk -v first="$first" -v last="$last" 'NR >= first && NR <= last' "$main" | sed 's/(.*//' | sort | uniq -c >calls
cat calls
[ "$(wc -l <calls)" -eq 1 ] || fail "other system calls than the sleep"
[ "$(awk '{print $1}' calls)" -ge 500 ] || fail "fewer than 500 sleeps were traced"
