# Output files: ours are replaced, others are left alone, failures are said and leave nothing.
. "$(dirname "$0")/common.sh"
run_log good "${quiet_machine[@]}"
all=(--csv holes.csv --json=holes.json --plot holes.svg --plot holes.png)

expect_code 0 "$holes" good.lcm "${all[@]}"
for f in holes.csv holes.json holes.svg holes.png; do
    [ -s "$f" ] || fail "$f was not written"
    cp "$f" "first.$f"
done
: >after
ls >before
expect_code 0 "$holes" good.lcm "${all[@]}"
ls >after
cmp before after || fail "files were left behind"
for f in holes.csv holes.json holes.svg holes.png; do
    cmp "$f" "first.$f" || fail "$f: the same log gave another file"
done

# the picture: both marks differ in shape, the worst is named, nothing is a script's leftover
head -c 8 holes.png | cmp - <(printf '\211PNG\r\n\032\n') || fail "holes.png is not a PNG"
expect_part holes.svg "worst: hole "
expect_part holes.svg "inside (4)"
grep -q "outside (" holes.svg && fail "a mark in the key that no hole has"
run_log rough
expect_code 1 "$holes" rough.lcm --plot rough.svg
expect_part rough.svg "outside ("

# what is not ours stays as it is, and the other outputs are still written
for f in notes.csv notes.json notes.svg notes.png; do
    echo "my notes" >"$f"
done
rm holes.*
expect_code 2 "$holes" good.lcm --csv notes.csv --json=notes.json --plot notes.svg --plot notes.png \
    --plot holes.svg
expect_text err "exk-holes: notes.csv: exists and is not an earlier result of this kind, so it is left as it is: choose another name or remove it"
expect_text err "exk-holes: notes.json: exists and is not an earlier result of this kind, so it is left as it is: choose another name or remove it"
expect_text err "exk-holes: notes.svg: exists and is not an SVG picture made by gnuplot, so it is left as it is: choose another name or remove it"
expect_text err "exk-holes: notes.png: exists and is not a PNG picture, so it is left as it is: choose another name or remove it"
for f in notes.csv notes.json notes.svg notes.png; do
    [ "$(cat "$f")" = "my notes" ] || fail "$f was overwritten"
done
[ -s holes.svg ] || fail "the good picture was not written beside refused ones"
# a run's log is no place for a result either
expect_code 2 "$holes" good.lcm --csv good.lcm
"$holes" good.lcm -q >/dev/null || fail "the log was harmed"

expect_code 3 "$holes" good.lcm --csv nowhere/holes.csv
expect_text err "exk-holes: nowhere/holes.csv: cannot be written there: No such file or directory"
expect_code 3 "$holes" good.lcm --csv /dev/full
expect_text err "exk-holes: /dev/full: could not be written: No space left on device"
got=0
"$holes" good.lcm >/dev/full 2>err || got=$?
[ "$got" -eq 3 ] || fail "a full standard output ended with $got"
expect_text err "exk-holes: standard output: could not be written: No space left on device"
got=0
PATH=/nowhere "$holes" good.lcm --plot none.svg >out 2>err || got=$?
[ "$got" -eq 3 ] || fail "without gnuplot it ended with $got"
expect_part err "gnuplot draws the pictures and cannot be started"
[ -e none.svg ] && fail "half a picture was left"
exit 0
