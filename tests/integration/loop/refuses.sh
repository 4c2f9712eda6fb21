# What cannot be run is refused before anything starts, each with what, where and what to do.
. "$(dirname "$0")/common.sh"
expect_code 2 "$bin/exk-loop"
expect_part err "a PROFILE is missing"
expect_code 2 "$bin/exk-loop" ""
expect_text err "exk-loop: PROFILE: the name is empty"
expect_code 2 "$bin/exk-loop" "$profiles/rectangle.ini" --fast -r ""
expect_text err "exk-loop: --record: the name is empty"
expect_code 3 "$bin/exk-loop" nowhere.ini
expect_text err "nowhere.ini: cannot be opened: No such file or directory"

short far.ini -e 's/^kind *=.*/kind = csv\nfile = far.csv/' -e '/^width_mm\|^height_mm/d' \
    -e 's/^model *=.*/model = machine/'
printf 'id,x_mm,y_mm\n1,0,0\n17,900,0\n' >far.csv
expect_code 2 "$bin/exk-loop" far.ini --fast -r far.lcm
expect_part err "far.ini: hole 17: the machine cannot travel to it at x "
expect_part err "; move the hole or change [machine]"
[ -e far.lcm ] && fail "a log was started for a refused job"

short rate.ini
sed -i 's/^rate_Hz *=.*//; s/^\[loop\]/[loop]\nrate_Hz = -1000/' rate.ini
expect_code 2 "$bin/exk-loop" rate.ini --check
expect_part err "rate_Hz"
short good.ini
expect_code 0 "$bin/exk-loop" good.ini --check
expect_part out "good.ini: good: model pendulum, 4 holes, "
expect_code 0 "$bin/exk-loop" good.ini --print
cp out printed.ini
expect_code 0 "$bin/exk-loop" printed.ini --print
cmp out printed.ini || fail "--print does not read back to itself"

echo "my notes" >notes.lcm
expect_code 2 "$bin/exk-loop" good.ini --fast -r notes.lcm
expect_text err "exk-loop: notes.lcm exists and is not an LCM log: not overwritten; choose another name or move it away"
[ "$(cat notes.lcm)" = "my notes" ] || fail "a file that is not ours was overwritten"
exit 0
