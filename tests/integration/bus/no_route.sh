# No multicast route: exit 3 and the one line that cures it; with that line it works.
. "$(dirname "$0")/common.sh"
alone="unshare -rn" # a network of its own; root needs no user namespace
[ "$(id -u)" = 0 ] && alone="unshare -n"
$alone true 2>/dev/null || exit 77
expect_code 3 $alone "$bin/exk-log" run.lcm --url="$url" --seconds 0.1
expect_text err "exk-log: no route for multicast (239.255.76.67: Network is unreachable): run \`ip route add 224.0.0.0/4 dev lo\` as root, then again"
[ -e run.lcm ] || [ -e run.lcm.part ] && fail "a log was started without a bus"
command -v ip >/dev/null || exit 0
short p.ini
cat >cured.sh <<END
ip link set lo up && ip route add 224.0.0.0/4 dev lo || exit 9
"$bin/exk-log" run.lcm --until-done --url="$url" &
sleep 0.5
"$bin/exk-loop" p.ini -q --url="$url" || exit 8
wait \$!
END
expect_code 0 $alone sh cured.sh
exit 0
