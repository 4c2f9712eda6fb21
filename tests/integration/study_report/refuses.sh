#!/usr/bin/env bash
# What is not ours is left alone; foreign results and a missing gnuplot are said.
source "$(dirname "$0")/common.sh"

refused() {
    local want=$1 text=$2 code=0
    shift 2
    PATH=${path:-$PATH} "$bin/exk-study" paper --seeds 10 --only S6 --profiles "$profiles" "$@" >out 2>said || code=$?
    [[ $code == "$want" ]] || fail "$*: exit $code, wanted $want: $(cat said)"
    grep -qF -- "$text" said || fail "$*: wanted '$text', said: $(cat said)"
}

"$bin/exk-study" compare --seeds 10 --profiles "$profiles" --json compare.json >/dev/null
echo "my notes" >notes.html
refused 2 "notes.html: exists and is not an earlier result" --compare compare.json \
    --report notes.html
[[ $(cat notes.html) == "my notes" ]] || fail "notes.html was changed"

echo '{"controllers": [' >cut.json
echo '{"other": []}' >other.json
refused 2 "cut.json: line 2" --compare cut.json --report page.html
refused 2 'other.json: has no list "controllers": give a file that exk-study compare' \
    --compare other.json --report page.html
refused 2 'other.json: has no list "sensitivity"' --sensitivity other.json --report page.html
refused 3 "absent.json" --compare absent.json --report page.html
echo '{"controllers": []}' >empty.json
refused 2 "the comparison lacks a controller" --compare empty.json --report page.html
[[ ! -e page.html ]] || fail "a refused page was left behind"

path=/nowhere refused 3 "page.html: gnuplot draws the pictures and cannot be started" \
    --compare compare.json --report page.html
[[ ! -e page.html ]] || fail "half a page was left behind"
