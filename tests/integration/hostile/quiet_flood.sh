# Under a flood, with a machine on the bus and commands allowed, the control thread makes no system call but
# the sleep, drops are counted, and the job is finished. Read from a trace of that thread.
. "$(dirname "$0")/../two/common.sh"
hostile=$7
command -v strace >/dev/null || { echo "strace is not installed"; exit 77; }
strace -o /dev/null true 2>/dev/null || { echo "tracing is not allowed here"; exit 77; }
expect_code 0 "$bin/exk-command" keygen op.key
short p.ini -e 's/^\[loop\]/[command]\nallow = yes\nkey_file = op.key\ntimeout_s = 0\n[loop]\nsource = bus\nmissed_max = 100000\nbad_max = 100000/'
machine p.ini --url="$url"
"$hostile" flood "$url" 100000000 >/dev/null &
children="$children $!"
strace -o trace.main "$bin/exk-loop" p.ini --url="$url" -r run.lcm >out 2>err || { cat out err; fail "exk-loop ended with $?"; }
expect_part out "4 of 4 holes drilled"
main=trace.main # without -f: the control thread alone
awk '/^clock_nanosleep/ {last = NR; if (!first) first = NR} END {print first, last}' "$main" >span
read -r first last <span
awk -v first="$first" -v last="$last" 'NR >= first && NR <= last' "$main" | sed 's/(.*//' | sort | uniq -c >calls
cat calls
[ "$(wc -l <calls)" -eq 1 ] || fail "other system calls than the sleep"
[ "$(awk '{print $1}' calls)" -ge 100 ] || fail "fewer than 100 sleeps were traced"
[ "$(status_of run.lcm malformed)" -gt 1000 ] || fail "the flood did not arrive"
exit 0
