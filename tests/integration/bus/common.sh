# Shared by the scripts here: argument 3 is this test's UDP port.
. "$(dirname "$0")/../loop/common.sh"
url="udpm://239.255.76.67:$3?ttl=0"
trap 'clean_up' EXIT
children=

clean_up() {
    [ -z "$children" ] || kill -9 $children 2>/dev/null
    cd / && rm -rf "$work"
}

# start command...: in the background, output to NAME.out and NAME.err, its id in $started
start() {
    "$@" >"$(basename "$1").out" 2>"$(basename "$1").err" </dev/null &
    started=$!
    children="$children $started"
}

# recorder FILE [option...]: exk-log on this test's bus; returns when it listens
recorder() {
    start "$bin/exk-log" --url="$url" "$@"
    local i
    for ((i = 0; i < 100; i++)); do
        [ -e "$1.part" ] && return
        sleep 0.05
    done
    cat exk-log.err >&2
    fail "exk-log does not listen"
}

# ends ID N: waits for it and wants exit code N
ends() {
    local got=0
    wait "$1" || got=$?
    [ "$got" -eq "$2" ] || { cat ./*.out ./*.err >&2; fail "process ended with $got, not $2"; }
}

# count WHAT FILE: the number on the line of a report that begins with WHAT
count() { awk -v what="$1" '{ line = $0; sub(/^ +/, "", line) }
    index(line, what " ") == 1 { sub(what, "", line); print line + 0; exit }' "$2"; }
