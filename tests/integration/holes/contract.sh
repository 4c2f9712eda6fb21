# The JSON and CSV that others rely on, on runs of exk-loop; exit code and words of the table agree.
. "$(dirname "$0")/common.sh"

# check NAME CODE: judged with this exit code, JSON on stdout and in a file alike, held to the contract
check() {
    expect_code "$2" "$holes" "$1.lcm" --json --csv "$1.csv"
    mv out "$1.json"
    "$helpers/check-json" "$1.json" "$1.csv" || fail "$1.json does not keep the contract"
    expect_code "$2" "$holes" "$1.lcm" --json="$1.file.json" -q
    cmp "$1.json" "$1.file.json" || fail "--json and --json=FILE differ"
    mv out "$1.table"
}

run_log rough
check rough 1
grep -q '"noise": "frozen"' rough.json || fail "frozen noise not said"
grep -q '"judged_on": "true"' rough.json || fail "judged on the true tip not said"
expect_part rough.table "judged on the true tool tip; noise frozen; tolerance 0.03 mm; "
expect_part rough.table "  Mazak, measured machine          ?     100.0 %   0.011417"
expect_part rough.table "  Loxin, measured machine          ?      80.0 %   0.024466"
expect_part rough.table "  Exechon, published model        45      82.2 %   0.023614"
worst=$(sort -t, -k7,7 -g -r rough.csv | head -n 1 | cut -d, -f1)
expect_part rough.table " mm at hole $worst, the worst"
expect_code 0 "$holes" rough.lcm --report-only
cmp out rough.table || fail "--report-only changes the table"

run_log quiet "${quiet_machine[@]}"
check quiet 0
expect_part quiet.table "inside          4 of 4 = 100.0 % (95 % Wilson: 51.0 to 100.0 %)"
expect_code 1 "$holes" quiet.lcm --tolerance 1e-9
expect_part out "inside          0 of 4 = 0.0 %"

run_log fresh -e 's/^repeat *=.*/repeat = fresh/'
check fresh 1
grep -q '"noise": "fresh"' fresh.json || fail "fresh noise not said"

# CSV on standard output takes the place of the table
expect_code 1 "$holes" rough.lcm --csv -
cmp out rough.csv || fail "--csv - and --csv FILE differ"

# no colour into a file; on a terminal colour, unless NO_COLOR
grep -q "$(printf '\033')" rough.table && fail "colour in a file"
if script -qec true /dev/null >script.log 2>&1; then
    TERM=xterm script -qec "$holes rough.lcm" /dev/null </dev/null >tty
    grep -q "$(printf '\033')" tty || fail "no colour on a terminal"
    NO_COLOR=1 TERM=xterm script -qec "$holes rough.lcm" /dev/null </dev/null >tty
    grep -q "$(printf '\033')" tty && fail "colour in spite of NO_COLOR"
fi
exit 0
