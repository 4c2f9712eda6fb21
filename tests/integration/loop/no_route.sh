# No multicast route: said with the remedy, exit 3, nothing started; off the bus it runs all the same.
. "$(dirname "$0")/common.sh"
alone="unshare -rn" # a network of its own; root needs no user namespace
[ "$(id -u)" = 0 ] && alone="unshare -n"
$alone true 2>/dev/null || exit 77
short p.ini
expect_code 3 $alone "$bin/exk-loop" p.ini -r run.lcm
expect_text err "exk-loop: no route for multicast (239.255.76.67: Network is unreachable): run \`ip route add 224.0.0.0/4 dev lo\` as root, then again"
[ -e run.lcm ] && fail "a log was started without a bus"
expect_code 0 $alone "$bin/exk-loop" p.ini --fast -r run.lcm
exit 0
