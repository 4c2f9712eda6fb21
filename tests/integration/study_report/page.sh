#!/usr/bin/env bash
# The page is whole, stands alone, is the same each time, and says what the JSON says.
source "$(dirname "$0")/common.sh"
check=$3/check-page

# The checker finds what it is there for.
refuses() {
    printf '%s' "$2" >bad.html
    if "$check" bad.html here >said; then
        fail "check-page took $1"
    fi
    grep -qF -- "$3" said || fail "$1: wanted '$3', found: $(cat said)"
}
refuses "an open tag" '<p id="here"><b>x</p>' "closed out of order: p"
refuses "two ids" '<p id="here"></p><p id="here"></p>' "id used twice: here"
refuses "a missing figure" '<p></p>' "is not there: here"
refuses "a dead anchor" '<p id="here"><a href="#there">x</a></p>' "refers to nothing: there"
refuses "a link out" '<p id="here"><a href="other.html">x</a></p>' "leads out of the page"
refuses "a network address" '<p id="here">http://x</p>' "is in the page: http:"
refuses "a script" '<p id="here"></p><script></script>' "does not belong here: script"

make_page
"$check" page.html "${figures[@]}" "${sections[@]}" >said || fail "$(cat said)"
grep -q "^$n_drawings drawings" said || fail "wanted $n_drawings drawings: $(cat said)"

# Each claim of the JSON stands in the page with its mean.
claims=0
while IFS=$'\t' read -r id mean; do
    grep -q "<th scope=\"row\">$id</th>.*>$mean<" page.html || fail "$id: $mean is not in the page"
    claims=$((claims + 1))
done < <(awk -F'[:,]' '/"id"/ {gsub(/[ "]/, "", $2); id = $2}
    /"claim"/ {id = ""}
    /"mean"/ && id != "" {printf "%s\t%.5f\n", id, $2; id = ""}' paper.json)
((claims == 12)) || fail "$claims claims in the JSON, wanted 12"

# Part of the study: its figures, and no others; the same bytes each time.
part() {
    "$bin/exk-study" paper --seeds 20 --only S5 --profiles "$profiles" --compare compare.json \
        --report "$1" -j "$2" >/dev/null
}
part part.html 1
part again.html 2
part again.html 2 # over its own kind
cmp part.html again.html
"$check" part.html fig-overview fig-last-point fig-spread fig-own "${sections[@]}" >said ||
    fail "$(cat said)"
for figure in "${figures[@]}"; do
    case $figure in
    fig-overview | fig-last-point | fig-spread | fig-own) ;;
    *) ! grep -q "id=\"$figure\"" part.html || fail "$figure without its experiment" ;;
    esac
done
