# A full disk while recording: said once with what is left, exit 3, the part ends at a whole record.
. "$(dirname "$0")/common.sh"
mkdir small
mount -t tmpfs -o size=128k tmpfs small 2>/dev/null || exit 77
trap 'umount "$work/small"; clean_up' EXIT
recorder small/bus.lcm --until-done
log=$started
"$bin/exk-loop" "$profiles/rectangle.ini" --url="$url" -q >/dev/null 2>&1 &
children="$children $!"
ends "$log" 3
expect_text exk-log.err "exk-log: small/bus.lcm: recording stopped: No space left on device (make room, or record elsewhere); all whole records before stay in small/bus.lcm.part"
[ -e small/bus.lcm ] && fail "half a log looks whole"
expect_code 0 "$bin/exk-log" --from small/bus.lcm.part
[ "$(count samples out)" -gt 100 ] || fail "hardly a sample is left"
grep -q "inside a record" err && fail "the part ends inside a record"
exit 0
