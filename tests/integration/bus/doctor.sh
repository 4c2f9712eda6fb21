# The doctor finds a working bus working, and a missing route missing, with the remedy.
. "$(dirname "$0")/common.sh"
expect_code 0 "$bin/exk-doctor" --url="$url"
grep -q "^ok    messages   200 messages there and back" out || { cat out; fail "no round trip"; }
[ "$(wc -l <out)" -ge 9 ] || fail "a check is missing"
expect_code 0 "$bin/exk-doctor" --url="udpm://239.255.76.67:$3?ttl=1" --json=d.json
expect_part d.json '"state": "warn"'
expect_part d.json '"found": "ttl=1: every host on this network sees the machine'
expect_code 2 "$bin/exk-doctor" --url=nonsense://
unshare -rn true 2>/dev/null || exit 0
expect_code 1 unshare -rn "$bin/exk-doctor" --url="$url"
expect_text out "fail  route      no route for multicast (239.255.76.67: Network is unreachable)"
expect_text out "                 -> \`ip route add 224.0.0.0/4 dev lo\` as root (lasts until the next start)"
exit 0
