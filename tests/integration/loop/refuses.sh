# What cannot be run is refused before anything starts, each with what, where and what to do.
. "$(dirname "$0")/common.sh"
expect_code 2 "$bin/exk-loop"
expect_text err "exk-loop: a PROFILE is missing, for example profiles/rectangle.ini"
expect_code 2 "$bin/exk-loop" ""
expect_text err "exk-loop: PROFILE: the name is empty"
expect_code 2 "$bin/exk-loop" "$profiles/rectangle.ini" --fast -r ""
expect_text err "exk-loop: --record: the name is empty"
expect_code 3 "$bin/exk-loop" nowhere.ini
expect_text err "nowhere.ini: cannot be opened: No such file or directory"

short good.ini
expect_code 0 "$bin/exk-loop" good.ini --check
expect_text out "good.ini: good: model pendulum, 4 holes, 1200 ticks of 0.001 s (1.200 s)"
expect_code 0 "$bin/exk-loop" good.ini --print
cp out printed.ini
expect_code 0 "$bin/exk-loop" printed.ini --print
cmp out printed.ini || fail "--print does not read back to itself"

echo "my notes" >notes.lcm
expect_code 2 "$bin/exk-loop" good.ini --fast -r notes.lcm
expect_text err "exk-loop: notes.lcm exists and is not an LCM log: not overwritten; choose another name or move it away"
[ "$(cat notes.lcm)" = "my notes" ] || fail "a file that is not ours was overwritten"
exit 0
