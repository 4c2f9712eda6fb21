# A run recorded from the bus by another process is the run that exk-loop wrote itself: every sample,
# to the last bit.
. "$(dirname "$0")/common.sh"
short p.ini
recorder bus.lcm --until-done --csv bus.csv --json=bus.json --plot path.svg --plot path.png
log=$started
expect_code 0 "$bin/exk-loop" p.ini --url="$url" -r own.lcm
ends "$log" 0
expect_code 0 "$bin/exk-log" --from own.lcm --csv own.csv
cmp bus.csv own.csv || fail "the samples on the bus are not those of the process"
[ "$(count samples exk-log.out)" -eq "$(($(wc -l <own.csv) - 1))" ] || fail "samples miscounted"
for what in lost repeated "not decoded"; do
    [ "$(count "$what" exk-log.out)" -eq 0 ] || { cat exk-log.out; fail "$what is not 0"; }
done
expect_part bus.json '"lost_samples": 0,'
expect_part bus.json '"ended": "done",'
[ -e bus.lcm.part ] && fail "the part is left"
if command -v gnuplot >/dev/null; then
    expect_part path.svg "error enlarged"
    [ "$(head -c 4 path.png | tail -c 3)" = PNG ] || fail "path.png is no PNG"
fi
# the last status says how the run went
expect_code 0 "$bin/exk-holes" bus.lcm --report-only --json=bus_holes.json
expect_code 0 "$bin/exk-holes" own.lcm --report-only --json=own_holes.json
cmp bus_holes.json own_holes.json || fail "the holes differ"
exit 0
