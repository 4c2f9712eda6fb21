# Started with standard streams closed, as some supervisors do: what would be said there does not end up
# in the log or the store instead, and a result that nobody gets is still exit 3.
. "$(dirname "$0")/common.sh"
short p.ini -e 's/^\[loop\]/[loop]\nmissed_max = 100000/'
# code_of command...: its exit code, 0 to 2 being what the caller made of them
code_of() { code=0; "$@" || code=$?; }
whole() { expect_code 0 "$bin/exk-log" --from "$1"; expect_part out "  samples  "; expect_part out "of 1"; }

code_of "$bin/exk-loop" p.ini --no-bus -r all.lcm <&- >&- 2>&-
[ "$code" -eq 3 ] || fail "a lost result ended with $code"
whole all.lcm
code_of "$bin/exk-loop" p.ini --no-bus -r err.lcm >out 2>&-
[ "$code" -eq 0 ] || fail "a run without standard error ended with $code"
expect_part out "4 of 4 holes drilled"
whole err.lcm
code_of "$bin/exk-loop" p.ini --fast -r fast.lcm <&-
[ "$code" -eq 0 ] || fail "a run without standard input ended with $code"
expect_code 0 "$bin/exk-loop" p.ini --fast -r as_ever.lcm
cmp fast.lcm as_ever.lcm || fail "a closed standard input changed the log"
code_of "$bin/exk-ilc" train p.ini -n 1 -o p.ilc <&- >&- 2>&-
[ "$code" -eq 3 ] || fail "a lost table ended with $code"
expect_code 0 "$bin/exk-ilc" verify p.ilc p.ini
# a reader that goes (| head) does not cost what was learned
(sleep 0.3; code_of "$bin/exk-ilc" train p.ini -n 2 -o pipe.ilc; echo "$code" >code) | true
while [ ! -s code ]; do sleep 0.1; done
[ "$(cat code)" -eq 3 ] || fail "a table that nobody read ended with $(cat code)"
expect_code 0 "$bin/exk-ilc" verify pipe.ilc p.ini
code_of "$bin/exk-kin" inverse --model pendulum <&- 2>err
[ "$code" -eq 3 ] || { cat err; fail "no standard input to read ended with $code"; }
exit 0
