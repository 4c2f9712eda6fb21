# Sourced by the tests of exk-study: BIN PROFILES.
set -euo pipefail
study=$1/exk-study
profiles=$2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"

fail() {
    echo "FAILED: $*"
    exit 1
}

run() {
    "$study" "$@" --profiles "$profiles/study" --only S5,S6 >/dev/null
}
