# A full disk: the controller finishes its job, says so once, exit 3; what is left ends at a whole record.
. "$(dirname "$0")/common.sh"
mkdir small
mount -t tmpfs -o size=256k tmpfs small 2>/dev/null || exit 77
trap 'umount "$work/small"; rm -rf "$work"' EXIT
expect_code 3 "$bin/exk-loop" "$profiles/rectangle.ini" --fast -r small/run.lcm
expect_text err "exk-loop: small/run.lcm: recording stopped: No space left on device (make room, or record elsewhere); all whole records before stay in small/run.lcm.part"
[ "$(grep -c 'No space left' err)" -eq 1 ] || fail "said more than once"
expect_part out "4 of 4 holes drilled"
expect_code 3 "$bin/exk-ilc" train "$profiles/rectangle.ini" -n 1 -o small/full.ilc
expect_text err "exk-ilc: small/full.ilc: cannot write the ILC store: No space left on device"
[ -e small/full.ilc ] && fail "half a store is left"
# results that cannot be printed are a failure, whatever the run was
full() {
    local got=0
    "$@" >/dev/full 2>err || got=$?
    [ "$got" -eq 3 ] || fail "$* on a full standard output ended with $got, not 3"
}
short p.ini
expect_code 0 "$bin/exk-ilc" train p.ini -n 1 -o p.ilc
full "$bin/exk-loop" p.ini --fast
expect_text err "exk-loop: standard output: could not be written: No space left on device"
full "$bin/exk-loop" p.ini --check
full "$bin/exk-loop" p.ini --print
full "$bin/exk-ilc" train p.ini -n 1
full "$bin/exk-ilc" show p.ilc
full "$bin/exk-ilc" verify p.ilc
expect_text err "exk-ilc: standard output: could not be written: No space left on device"
exit 0
