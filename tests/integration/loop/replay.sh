# Angles replayed from a log: the same measurements again, whatever the controller does now.
. "$(dirname "$0")/common.sh"
short p.ini
expect_code 0 "$bin/exk-loop" p.ini --fast -r first.lcm
sed '/^\[loop\]/a source = replay\nreplay_file = first.lcm' p.ini >replay.ini
expect_code 0 "$bin/exk-loop" replay.ini --fast -r again.lcm
expect_part out "(judged on the estimated tip)"
expect_code 0 "$bin/exk-log" --from first.lcm --csv first.csv
expect_code 0 "$bin/exk-log" --from again.lcm --csv again.csv
column() { head -1 "$1" | tr ',' '\n' | grep -nxF "$2" | cut -d: -f1; }
c=$(column first.csv alpha_measured_rad)
[ -n "$c" ] || fail "no column alpha_measured_rad"
cut -d, -f"$c" first.csv >a
cut -d, -f"$c" again.csv >b
cmp a b || fail "the replayed angles differ"
exit 0
