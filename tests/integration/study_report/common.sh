# Sourced by the tests of the report: BIN PROFILES FOLDER. Makes one page of few seeds and keeps it.
set -euo pipefail
bin=$1
profiles=$2/study
command -v gnuplot >/dev/null || exit 77
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"

figures=(fig-overview fig-sine fig-awgn fig-force fig-ilc fig-last-point fig-grid25 fig-by-hole
    fig-grid45 fig-spread fig-own)
sections=(verdict words paths learning holes spread fitted own repeat)
n_drawings=$((1 + 4 + 4 + 4 + 4 + 1 + 2 + 2 + 2 + 8 + 3))

fail() {
    echo "FAILED: $*"
    exit 1
}

make_page() {
    "$bin/exk-study" compare --seeds 10 --profiles "$profiles" --json compare.json >/dev/null
    "$bin/exk-study" paper --seeds 20 --profiles "$profiles" --compare compare.json \
        --json paper.json --report page.html >/dev/null
}
