#!/usr/bin/env bash
# What exk-kin promises of its rows: contract.sh EXK_KIN SOURCE_DIR
set -uo pipefail
kin=$1
poses=$2/tests/data/tripod_poses.csv
profile=$2/profiles/machine.ini
n_failed=0

# expect NAME WANT_RC WANT_OUTPUT ARGS... : rows on our stdin
expect() {
    local name=$1 want_rc=$2 want=$3
    shift 3
    local got rc
    got=$("$kin" "$@" 2>/dev/null)
    rc=$?
    if [[ $rc -ne $want_rc || $got != "$want" ]]; then
        printf 'FAIL %s: exit %s, wanted %s\n--- got\n%s\n--- wanted\n%s\n' \
            "$name" "$rc" "$want_rc" "$got" "$want"
        n_failed=$((n_failed + 1))
    fi
}

# Compares two numeric CSVs cell by cell; near FILE FILE TOLERANCE
# shellcheck disable=SC2317 # called through check
near() {
    paste -d '|' "$1" "$2" | awk -F '|' -v most="$3" '
        { n = split($1, a, ","); m = split($2, b, ",")
          if (n != m) { bad = 1 }
          for (i = 1; i <= n; i++) {
              d = a[i] - b[i]; if (d < 0) { d = -d }
              if (!(d <= most) || a[i] == "") { bad = 1 }
          } }
        END { exit bad || NR == 0 }'
}

check() {
    if ! "${@:2}"; then
        printf 'FAIL %s\n' "$1"
        n_failed=$((n_failed + 1))
    fi
}

expect 'home of the tripod' 0 'alpha_rad,beta_rad,l1_m,l2_m,l3_m,status
0,0,0.98762341001011111,1.0511898020814319,0.98762341001011111,ok' \
    inverse --model tripod <<<$'x_m,y_m,z_m\n0,0,0.95'

expect 'columns in any order, others passed over, quotes, CRLF, comments and blank lines' 0 \
    'alpha_rad,beta_rad,l1_m,l2_m,l3_m,status
0,0,0.98762341001011111,1.0511898020814319,0.98762341001011111,ok' \
    inverse --model tripod < <(
        printf '\xef\xbb\xbf# a note\r\n\r\n"z_m",name,y_m,x_m\r\n0.95,"a, ""b""", 0 ,0\r\n\r\n')

expect 'a row without a solution keeps its place' 1 'alpha_rad,beta_rad,l1_m,l2_m,l3_m,status
,,,,,unreachable
,,,,,beyond limit
,,,,,singular
,,,,,bad argument
,,,,,bad argument
,,,,,bad argument
0,0,0.98762341001011111,1.0511898020814319,0.98762341001011111,ok' \
    inverse --model tripod <<<$'x_m,y_m,z_m
5,0,0.95\n0.5,0,1.1\n0,0.36,0.36\nnan,0,0.95\n0,-inf,0.95\n,0,0.95\n0,0,0.95'

expect 'a header alone gives a header' 0 'x_m,y_m,z_m,status' \
    forward --model pendulum <<<'alpha_rad,beta_rad'

expect 'lengths beyond the stroke' 1 'x_m,y_m,z_m,alpha_rad,beta_rad,status
,,,,,beyond limit' \
    forward --model tripod <<<$'l1_m,l2_m,l3_m\n1.4,1,1'

expect 'pendulum: beyond 0.6 rad, and longer than the bar' 1 'alpha_rad,beta_rad,status
,,beyond limit
,,unreachable' \
    inverse --model pendulum <<<$'x_m,y_m\n0.6,0\n1.1,0'

expect 'pendulum, Jacobian at the centre' 0 'j11,j12,j21,j22,status
1.0511898020814319,0,0,0.94999999999999996,ok' \
    jacobian --model pendulum <<<$'x_m,y_m\n0,0'

expect 'universal, Jacobian at the centre' 0 'j11,j12,j21,j22,status
0.94999999999999996,0,0,0.94999999999999996,ok' \
    jacobian --model universal <<<$'y_m,x_m\n0,0'

expect 'machine: CA has no answer with the tool along the plate axis' 1 \
    'alpha_rad,beta_rad,l1_m,l2_m,l3_m,t4_rad,t5_rad,status
,,,,,,,singular' \
    inverse --model machine --wrist CA <<<$'x_m,y_m,z_m,nx,ny,nz\n0,0,1.45,0,0,1'

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

columns() { tail -n +2 | cut -d, -f"$1"; }

# Model, wrist and geometry of a profile: with e 50 mm longer, home is 50 mm farther out.
echo '0,0,0.98762341001011111,1.0511898020814319,0.98762341001011111,0,0' >"$work/want"
"$kin" inverse --profile "$profile" <<<$'x_m,y_m,z_m,nx,ny,nz\n0,0,1.45,0,0,1' |
    columns 1-7 >"$work/got"
check 'machine: the model and wrist of a profile' near "$work/got" "$work/want" 1e-14
for model in pendulum universal; do
    sed "s/^model *=.*/model = $model/" "$profile" >"$work/$model.ini"
    check "the model $model of a profile" [ "$("$kin" inverse --profile "$work/$model.ini" \
        <<<$'x_m,y_m\n0,0' | tail -n 1)" = 0,0,ok ]
done
sed 's/^\[machine\]/&\ne_mm = 250/' "$profile" >"$work/longer.ini"
"$kin" inverse --profile "$work/longer.ini" <<<$'x_m,y_m,z_m,nx,ny,nz\n0,0,1.5,0,0,1' |
    columns 1-7 >"$work/got"
check 'machine: the geometry of a profile' near "$work/got" "$work/want" 1e-14
sed 's/^wrist *=.*/wrist = CA/' "$profile" >"$work/ca.ini"
expect 'machine: the wrist of a profile' 1 \
    'alpha_rad,beta_rad,l1_m,l2_m,l3_m,t4_rad,t5_rad,status
,,,,,,,singular' \
    inverse --profile "$work/ca.ini" <<<$'x_m,y_m,z_m,nx,ny,nz\n0,0,1.45,0,0,1'

# The 200 reference poses through the process, there and back.
grep -v '^#' "$poses" | sed '1s/,x,y,z,/,x_m,y_m,z_m,/' >"$work/poses.csv"
"$kin" inverse --model tripod <"$work/poses.csv" >"$work/legs.csv" || n_failed=$((n_failed + 1))
columns 1-5 <"$work/legs.csv" >"$work/got"
columns 5-9 <"$work/poses.csv" >"$work/want"
check 'reference poses: angles and lengths' near "$work/got" "$work/want" 1e-12
check 'reference poses: 200 rows ok' [ "$(grep -c ',ok$' "$work/legs.csv")" -eq 200 ]
"$kin" forward --model tripod <"$work/legs.csv" >"$work/back.csv" || n_failed=$((n_failed + 1))
columns 1-5 <"$work/back.csv" >"$work/got"
columns 2-6 <"$work/poses.csv" >"$work/want"
check 'reference poses: back from the lengths' near "$work/got" "$work/want" 1e-12
"$kin" jacobian --model tripod <"$work/poses.csv" | columns 1-9 >"$work/got"
columns 28-36 <"$work/poses.csv" >"$work/want"
check 'reference poses: Jacobian' near "$work/got" "$work/want" 1e-9

# The machine's Jacobian against central differences of its inverse, tool axis held.
tip='-0.2,0.05,1.40'
awk -v tip="$tip" 'BEGIN {
    print "x_m,y_m,z_m,nx,ny,nz"
    for (j = 1; j <= 3; j++) {
        for (sign = -1; sign <= 1; sign += 2) {
            split(tip, q, ","); q[j] += sign * 1e-5
            printf "%.17g,%.17g,%.17g,0,0,1\n", q[1], q[2], q[3]
        }
    }
}' | "$kin" inverse --model machine | columns 3-5 | awk -F, '
    { for (i = 1; i <= 3; i++) { l[NR, i] = $i } }
    END { for (i = 1; i <= 3; i++) {
              for (j = 1; j <= 3; j++) {
                  printf "%s%.17g", (i + j > 2 ? "," : ""), (l[2 * j, i] - l[2 * j - 1, i]) / 2e-5
              } }
          printf "\n" }' >"$work/want"
printf 'x_m,y_m,z_m,nx,ny,nz\n%s,0,0,1\n' "$tip" | "$kin" jacobian --model machine |
    columns 1-9 >"$work/got"
check 'machine: Jacobian against differences' near "$work/got" "$work/want" 1e-9

# Each model returns to where it came from, both wrists.
cat >"$work/tools.csv" <<'ROWS'
x_m,y_m,z_m,nx,ny,nz
0.15,0.10,1.45,0,0,1
-0.2,0.05,1.40,0.6e-1,-0.8e-1,0.99498743710661995
0.30,-0.20,1.45,0,0,1
ROWS
columns 1-6 <"$work/tools.csv" >"$work/want"
for wrist in AB CA; do
    "$kin" inverse --model machine --wrist $wrist <"$work/tools.csv" |
        "$kin" forward --model machine --wrist $wrist | columns 1-6 >"$work/got"
    check "machine $wrist: there and back" near "$work/got" "$work/want" 1e-12
done
printf 'x_m,y_m\n0.2,-0.3\n-0.5,0.4\n0,0\n' >"$work/plane.csv"
columns 1-2 <"$work/plane.csv" >"$work/want"
for model in pendulum universal; do
    "$kin" inverse --model $model <"$work/plane.csv" | "$kin" forward --model $model |
        columns 1-2 >"$work/got"
    check "$model: there and back" near "$work/got" "$work/want" 1e-14
done

# A row that failed keeps its place through a pipe as well.
piped=$(printf 'x_m,y_m,z_m\n9,9,9\n0,0,0.95\n' | "$kin" inverse --model tripod 2>/dev/null |
    "$kin" forward --model tripod 2>/dev/null | tail -n +2)
check 'a failed row through a pipe' [ "$piped" = $',,,,,bad argument\n0,0,0.95000000000000007,0,0,ok' ]

((n_failed == 0)) && echo 'all as promised'
exit $((n_failed > 0))
