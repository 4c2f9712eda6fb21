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

# exk-ilc train and exk-study as well, where the table does not show how far they are
narrow() { # NAME COMMAND WORDS
    script -qec "stty cols 30; $2 >$1.out" "$1" </dev/null >/dev/null || { cat "$1"; fail "$1 ended with $?"; }
    tr '\r' '\n' <"$1" | grep "$3" >progress || fail "$1: no progress on a terminal"
    [ "$(awk '{ if (length > n) n = length } END { print n }' progress)" -le 29 ] ||
        { cat progress; fail "$1: a progress line is wider than the terminal"; }
}
narrow train "$bin/exk-ilc train '$profiles/rectangle_ilc.ini' -n 2 --json" "run 2 of 2"
narrow study "$bin/exk-study compare --seeds 20 --profiles '$profiles/study' --json -" " %, "
expect_code 0 "$bin/exk-ilc" train "$profiles/rectangle_ilc.ini" -n 2 --json
[ -s err ] && { cat err; fail "exk-ilc train: progress where there is no terminal"; }
exit 0
