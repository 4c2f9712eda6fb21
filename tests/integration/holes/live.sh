# Live: the run on the bus is judged when it is done, as its log is.
. "$(dirname "$0")/common.sh"
url="udpm://239.255.76.67:$4?ttl=0"
short p.ini
# start_listener ARGS...: exk-holes --live in the background, back when it listens
start_listener() {
    "$holes" --live --url "$url" --seconds 60 "$@" >live.out 2>live.err &
    listener=$!
    for _ in $(seq 200); do
        grep -q "listening on" live.err && return
        kill -0 "$listener" 2>/dev/null || { grep -q "no route" live.err && exit 77; break; }
        sleep 0.1
    done
    cat live.err >&2
    fail "exk-holes --live does not listen"
}

start_listener --json
expect_text live.err "exk-holes: listening on $url"
"$bin/exk-loop" p.ini --url "$url" -r run.lcm -q >/dev/null || fail "exk-loop failed"
got=0
wait "$listener" || got=$?
want=0
"$holes" run.lcm --json >log.json 2>/dev/null || want=$?
[ "$got" -eq "$want" ] || { cat live.err >&2; fail "live ended with $got, its log with $want"; }
cmp live.out log.json || fail "live and log are judged differently"

# nobody speaks: said, and nothing judged
expect_code 2 "$holes" --live --url "$url" --seconds 0.3 -q
expect_text err "exk-holes: $url: no EXK_POSE message heard: start exk-loop on this URL, and check the route with exk-doctor"

# Ctrl-C ends it: what was heard is judged, the rest is named
short slow.ini
sed -i 's/^dwell_s *=.*/dwell_s = 5/' slow.ini
start_listener
"$bin/exk-loop" slow.ini --url "$url" -q >/dev/null &
loop=$!
sleep 2
kill -INT "$listener"
got=0
wait "$listener" || got=$?
kill -INT "$loop"
wait "$loop"
[ "$got" -eq 1 ] || { cat live.err >&2; fail "stopped by Ctrl-C it ended with $got"; }
expect_part live.out "never reached   4 holes: 1, 2, 3, 4"
exit 0
