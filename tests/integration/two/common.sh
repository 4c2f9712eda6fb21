# Shared by the scripts here: 3 and 4 are UDP ports, 5 the relay, 6 the reader of the last status.
. "$(dirname "$0")/../bus/common.sh"
url_behind="udpm://239.255.76.67:$4?ttl=0"
relay=$5
last_status=$6

# machine PROFILE [option...]: exk-twin on this test's bus; returns when it listens
machine() {
    start "$bin/exk-twin" "$@"
    local i
    for ((i = 0; i < 100; i++)); do
        grep -q "is on udpm" exk-twin.err && return
        sleep 0.02
    done
    cat exk-twin.err >&2
    fail "exk-twin does not listen"
}

# status_of LOG NAME: one count of the log's last status
status_of() { "$last_status" "$1" | awk -v name="$2" '$1 == name { print $2 }'; }

# expect_count LOG NAME TEST NUMBER, as in: expect_count run.lcm lost -eq 12
expect_count() {
    local got
    got=$(status_of "$1" "$2")
    [ "$got" "$3" "$4" ] || { "$last_status" "$1" >&2; fail "$1: $2 is $got, not $3 $4"; }
}
