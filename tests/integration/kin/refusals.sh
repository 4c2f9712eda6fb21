#!/usr/bin/env bash
# Each refusal of exk-kin with its exit status and its words: refusals.sh EXK_KIN SOURCE_DIR
set -uo pipefail
kin=$1
n_failed=0
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# expect NAME WANT_RC WANT_ON_STDERR INPUT ARGS...; the first line of stderr counts
expect() {
    local name=$1 want_rc=$2 want=$3 input=$4
    shift 4
    local said rc
    printf '%b' "$input" | "$kin" "$@" >"$work/out" 2>"$work/err"
    rc=$?
    said=$(head -n 1 "$work/err")
    if [[ $rc -ne $want_rc || $said != "$want" ]]; then
        printf 'FAIL %s: exit %s, wanted %s\n got    %s\n wanted %s\n' \
            "$name" "$rc" "$want_rc" "$said" "$want"
        n_failed=$((n_failed + 1))
    fi
}

in='exk-kin: standard input'
needs='needed are x_m,y_m,z_m, in any order'
tripod=(inverse --model tripod)

expect 'nothing on stdin' 2 "$in: no header; a first line x_m,y_m,z_m is needed" '' "${tripod[@]}"
expect 'comments alone' 2 "$in: no header; a first line x_m,y_m,z_m is needed" '# a\n\n' \
    "${tripod[@]}"
expect 'a column missing' 2 "$in, line 1: column z_m is missing in the header; $needs" \
    'x_m,y_m\n1,1\n' "${tripod[@]}"
expect 'a column without its unit' 2 \
    "$in, line 2: column x_m is missing in the header; $needs" '# a\nx,y_m,z_m\n1,1,1\n' \
    "${tripod[@]}"
expect 'a column twice' 2 \
    "$in, line 1: column y_m stands more than once in the header; $needs" \
    'x_m,y_m,y_m,z_m\n' "${tripod[@]}"
expect 'a short row' 2 "$in, line 3: 2 cells, but the header has 3" \
    'x_m,y_m,z_m\n0,0,0.95\n0,0\n' "${tripod[@]}"
expect 'a long row' 2 "$in, line 2: 4 cells, but the header has 3" 'x_m,y_m,z_m\n0,0,1,1\n' \
    "${tripod[@]}"
expect 'a word for a number' 2 "$in, line 3, column z_m: 'high' is not a number" \
    'x_m,y_m,z_m\n0,0,0.95\n0,0,high\n' "${tripod[@]}"
expect 'a unit behind a number' 2 "$in, line 2, column x_m: '1 mm' is not a number" \
    'x_m,y_m,z_m\n1 mm,0,0.95\n' "${tripod[@]}"
expect 'rows without a solution are counted' 1 \
    'exk-kin: 2 of 3 rows without a solution, see status' \
    'x_m,y_m,z_m\n9,0,1\n0,0,0.95\nnan,0,1\n' "${tripod[@]}"

expect 'no command' 2 'exk-kin: a command is missing: inverse, forward or jacobian' '' \
    --model tripod
expect 'another command' 2 \
    'exk-kin: unknown command invert: inverse, forward or jacobian is allowed' '' invert
expect 'two commands' 2 'exk-kin: one argument too many: forward' '' inverse forward
expect 'no model' 2 \
    'exk-kin: --model is missing: pendulum, universal, tripod or machine' '' inverse
expect 'another model' 2 \
    'exk-kin: --model delta: pendulum, universal, tripod or machine is allowed' '' \
    inverse --model delta
expect 'another wrist' 2 'exk-kin: --wrist BC: AB or CA is allowed' '' \
    inverse --model machine --wrist BC
expect 'a wrist where there is none' 2 \
    'exk-kin: --wrist goes with --model machine: tripod has no wrist' '' \
    inverse --model tripod --wrist AB

expect 'no such profile' 3 "$work/none.ini: cannot be opened: No such file or directory" '' \
    inverse --profile "$work/none.ini"
expect 'a folder for a profile' 3 "$work: cannot be read: Is a directory" '' \
    inverse --profile "$work"
printf '[machine]\0' >"$work/zero.ini"
expect 'a zero byte in the profile' 2 \
    "$work/zero.ini: not a text file: a zero byte stands in it" '' \
    inverse --profile "$work/zero.ini"

printf '[machine]\nd3_mm = 500\n' >"$work/ratio.ini"
"$kin" "${tripod[@]}" --profile "$work/ratio.ini" </dev/null >/dev/null 2>"$work/err"
rc=$?
if [[ $rc -ne 2 ]] || ! grep -q "^$work/ratio.ini.*p3 = 2 d3/d1" "$work/err"; then
    printf 'FAIL d3 outside its ratio: exit %s, wanted 2 and p3 named\n%s\n' "$rc" \
        "$(cat "$work/err")"
    n_failed=$((n_failed + 1))
fi

if [[ -w /dev/full ]]; then
    said=$(printf 'x_m,y_m,z_m\n0,0,0.95\n' | "$kin" "${tripod[@]}" 2>&1 >/dev/full)
    rc=$?
    want='exk-kin: standard output: could not be written: No space left on device'
    if [[ $rc -ne 3 || $said != "$want" ]]; then
        printf 'FAIL full disk: exit %s, wanted 3\n %s\n' "$rc" "$said"
        n_failed=$((n_failed + 1))
    fi
fi

((n_failed == 0)) && echo 'each refused as written'
exit $((n_failed > 0))
