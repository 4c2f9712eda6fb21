#!/usr/bin/env bash
# A tarball that is not the pinned one is refused and put nowhere: pin.sh SOURCE_DIR
set -euo pipefail
source "$1/cmake/unity.sh"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

fail() {
    printf '%s\n' "$@"
    exit 1
}

echo "not Unity" >"$work/$unity_tarball"
said=$(unity_unpack "$work" "$work/place") && fail "a wrong tarball was taken"
[[ $said == *"wrong sha256"*"$unity_sha256"* ]] || fail "the message names no hash:" "$said"
[[ ! -e $work/place ]] || fail "something was put in place"

mv "$work/$unity_tarball" "$work/ntpsec_9.9.9.orig.tar.xz"
said=$(unity_unpack "$work" "$work/place") && fail "another version was taken"
[[ $said == *"ntpsec_9.9.9.orig.tar.xz"* ]] || fail "the message does not name what was found:" "$said"
