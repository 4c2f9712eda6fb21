# No multicast route: said with the remedy, exit 3, nothing started; off the bus it runs all the same.
. "$(dirname "$0")/common.sh"
unshare -rn true 2>/dev/null || exit 77
short p.ini
expect_code 3 unshare -rn "$bin/exk-loop" p.ini -r run.lcm
expect_part err "ip route add 224.0.0.0/4 dev lo"
[ -e run.lcm ] && fail "a log was started without a bus"
expect_code 0 unshare -rn "$bin/exk-loop" p.ini --fast -r run.lcm
exit 0
