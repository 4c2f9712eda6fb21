#!/usr/bin/env bash
# bench/flood.sh [BUILD [PAIRS]]: step time of a 1 kHz run, quiet and under a flood of messages, in turns.
# BUILD is a build folder with its tests (default build/release), PAIRS the number of pairs (default 10).
# The flood lasts the whole run: 400,000 messages at full rate and more, again and again. Goal: the median step
# time at most 3 times the quiet one, every drop counted, the job finished. Exit status: 0 kept, 1 not, 2 use.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build=${1:-$root/build/release}
pairs=${2:-10}
for program in bin/exk-loop bin/exk-command tests/exk_hostile tests/exk_last_status; do
    [[ -x $build/$program ]] || { echo "flood: $build/$program is missing: build it with its tests" >&2; exit 2; }
done
build=$(cd "$build" && pwd)
work=$(mktemp -d)
flood=
trap '[[ -z $flood ]] || kill "$flood" 2>/dev/null; rm -rf "$work"' EXIT
cd "$work"
url="udpm://239.255.76.67:29999?ttl=0"
"$build/bin/exk-command" keygen op.key >/dev/null
sed -e 's/^dwell_s *=.*/dwell_s = 0.05/' -e 's/^width_mm *=.*/width_mm = 100/' -e 's/^height_mm *=.*/height_mm = 60/' -e 's/^tolerance_mm *=.*/tolerance_mm = 0.1/' \
    -e 's/^\[loop\]/[command]\nallow = yes\nkey_file = op.key\ntimeout_s = 0\n[loop]/' \
    "$root/profiles/rectangle.ini" >p.ini

# one NAME: a run; prints p50, p99 of the step in us, holes, missed ticks, messages refused, datagrams dropped
one() {
    "$build/bin/exk-loop" p.ini --url="$url" -r "$1.lcm" >"$1.out" 2>/dev/null || { cat "$1.out" >&2; exit 1; }
    local p50 p99 holes missed
    read -r p50 p99 < <(sed -n 's/^step time *p50 \([0-9.]*\) us, p99 \([0-9.]*\) us.*/\1 \2/p' "$1.out")
    holes=$(sed -n 's/.*: \([0-9]*\) of [0-9]* holes drilled, \([0-9]*\) inside.*/\1 \2/p' "$1.out")
    missed=$(sed -n 's/.* \([0-9]*\) missed.*/\1/p' "$1.out")
    echo "$p50 $p99 $holes $missed $("$build/tests/exk_last_status" "$1.lcm" |
        awk '$1 == "malformed" {m = $2} $1 == "dropped" {d = $2} END {print m, d}')"
}

printf '%-6s %8s %8s %6s %6s %7s %10s %10s\n' run "p50 us" "p99 us" holes inside missed refused dropped
for ((i = 1; i <= pairs; i++)); do
    quiet=$(one quiet)
    "$build/tests/exk_hostile" flood "$url" 1000000000 >/dev/null &
    flood=$!
    loud=$(one loud)
    kill "$flood"
    wait "$flood" 2>/dev/null || true
    flood=
    # shellcheck disable=SC2086
    { printf '%-6s %8s %8s %6s %6s %7s %10s %10s\n' quiet $quiet; printf '%-6s %8s %8s %6s %6s %7s %10s %10s\n' flood $loud; }
    echo "$quiet $loud" >>pairs
done
awk '{ r[NR] = $8 / $1; if ($10 != $3 || $11 != $4 || $4 == 0) off++; n += $13 + $14 }
    END { for (i = 1; i <= NR; i++) for (j = i + 1; j <= NR; j++) if (r[j] < r[i]) { t = r[i]; r[i] = r[j]; r[j] = t }
        m = NR % 2 ? r[(NR + 1) / 2] : (r[NR / 2] + r[NR / 2 + 1]) / 2
        printf "median of %d pairs: step p50 %.2f times the quiet one (goal 3); %d of the flood refused or dropped, counted; %d runs drilled otherwise\n", NR, m, n, off + 0
        exit !(m <= 3 && off == 0 && n > 0) }' pairs
