# Progress of exk-log and exk-holes --live on a narrow terminal keeps to one line; off a terminal there is none.
. "$(dirname "$0")/common.sh"
command -v script >/dev/null || exit 77
short p.ini -e 's/^dwell_s *=.*/dwell_s = 0.2/'

# listens NAME COMMAND: on a terminal of 30 columns until the run is done; its screen in NAME
listens() {
    script -qefc "stty cols 30; $2" "$1" </dev/null >/dev/null 2>&1 &
    listener=$!
    children="$children $listener"
    local i
    for ((i = 0; i < 100; i++)); do
        grep -q "waiting for a run" "$1" 2>/dev/null && break
        sleep 0.05
    done
    "$bin/exk-loop" p.ini --url "$url" -q >/dev/null || fail "exk-loop failed"
    wait "$listener" || true
}

# narrow NAME: no line of progress is wider than the terminal, and the run itself was seen
narrow() {
    tr '\r' '\n' <"$1" | grep -E "^$1: (waiting for a run|[0-9]+ lost,)" >progress || fail "$1: no progress on a terminal"
    grep -q '[0-9] lost,' progress || fail "$1: no progress while samples came"
    [ "$(awk '{ if (length > n) n = length } END { print n }' progress)" -le 29 ] ||
        { cat progress; fail "$1: a progress line is wider than the terminal"; }
}

listens exk-log "$bin/exk-log --url='$url' --until-done run.lcm --json=counts.json"
grep -q "no route" exk-log && exit 77
narrow exk-log
listens exk-holes "$bin/exk-holes --url='$url' --live --json=holes.json"
narrow exk-holes

recorder off.lcm --until-done
"$bin/exk-loop" p.ini --url "$url" -q >/dev/null || fail "exk-loop failed"
ends "$started" 0
grep -q "waiting for a run" exk-log.err && fail "progress where there is no terminal"
exit 0
