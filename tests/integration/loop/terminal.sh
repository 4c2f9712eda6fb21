# Progress on a narrow terminal keeps to one line and leaves nothing behind; off a terminal there is none.
. "$(dirname "$0")/common.sh"
command -v script >/dev/null || exit 77
short p.ini -e 's/^dwell_s *=.*/dwell_s = 0.4/'
script -qec "stty cols 30; $bin/exk-loop p.ini --no-bus" screen </dev/null >/dev/null || fail "on a terminal it ended with $?"
# script's own first and last line aside, what stands between carriage returns and line ends
tr '\r' '\n' <screen | grep ' %  hole ' >progress || fail "no progress on a terminal"
[ "$(awk '{ if (length > n) n = length } END { print n }' progress)" -le 29 ] ||
    { cat progress; fail "a progress line is wider than the terminal"; }
grep -q "$(printf '\033')" screen && fail "escape sequences on a terminal that was not asked what it knows"
expect_code 0 "$bin/exk-loop" p.ini --no-bus
grep -q '%  hole' err && fail "progress where there is no terminal"
exit 0
