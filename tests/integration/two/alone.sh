# Nobody answers, the machine dies, a second machine, a second controller: said clearly, once.
. "$(dirname "$0")/common.sh"
short p.ini -e 's/^\[loop\]/[loop]\nanswer_s = 0.3\nmissed_max = 100000\nbad_max = 50/'
expect_code 3 "$bin/exk-loop" p.ini --source bus --url="$url" --fast
expect_text err "exk-loop: no machine answers on $url within 0.3 s: start one first, for example exk-twin PROFILE, or take --source twin"

machine p.ini --url="$url"
twin=$started
for _ in 1 2 3 4; do # the holder is named however often it is asked
    expect_code 2 "$bin/exk-twin" p.ini --url="$url"
done
expect_text err "exk-twin: another machine is on $url: process $twin; end it first, or give this one a bus of its own (--url with another port)"

# the machine dies under a lock-step run, and under a paced one
for how in --fast ""; do
    start "$bin/exk-loop" "$profiles/machine.ini" --source bus --url="$url" $how -r dies.lcm
    loop=$started
    sleep 0.4
    kill -9 "$twin"
    wait "$twin" 2>/dev/null
    ends "$loop" 1
    if [ -n "$how" ]; then
        expect_part exk-loop.err "exk-loop: fault: no answer from the machine; tick "
        expect_part exk-loop.err "; is its process, for example exk-twin, still there"
    else
        expect_part exk-loop.err "exk-loop: fault: rejected sensor samples in a row: 20, limit 20, the last one missing"
        expect_part exk-loop.err "the machine's process"
    fi
    expect_count dies.lcm state = fault
    machine p.ini --url="$url"
    twin=$started
done

# a twin of another rate is another machine: no answer, and it says why
kill -9 "$twin"
wait "$twin" 2>/dev/null
sed 's/^rate_Hz *=.*/rate_Hz = 500/' p.ini >half.ini
machine half.ini --url="$url"
twin=$started
expect_code 1 "$bin/exk-loop" p.ini --source bus --url="$url" --fast
expect_part err "exk-loop: fault: no answer from the machine; tick 1, "
expect_part exk-twin.err "is at 1000 us in tick 1, this machine's profile has ticks of 2000 us: it gets no answer; start exk-twin with the profile of the controller"
[ "$(grep -c 'gets no answer' exk-twin.err)" -eq 1 ] || fail "said more than once"
# a controller that was there first: what it asked before anybody could hear is not lost
kill -9 "$twin"
wait "$twin" 2>/dev/null
sed 's/^answer_s *=.*/answer_s = 5/' p.ini >patient.ini
start "$bin/exk-loop" patient.ini --source bus --url="$url" --fast
loop=$started
sleep 0.5
expect_code 0 "$bin/exk-twin" p.ini --url="$url" --once
ends "$loop" 0
expect_part err "of its commands 0 were lost, 0 repeated, 0 out of order; 0 messages were none of its"

# whoever reads its notes may go: the machine stays
(sleep 0.3; exec "$bin/exk-twin" p.ini --url="$url") 2> >(true) &
children="$children $!"
sleep 0.6
for _ in 1 2; do
    expect_code 0 "$bin/exk-loop" patient.ini --source bus --url="$url" --fast
done

# a second controller while one runs; one off the bus is free to run
start "$bin/exk-loop" "$profiles/rectangle.ini" --url="$url" -q
loop=$started
sleep 0.5
expect_code 2 "$bin/exk-loop" p.ini --url="$url"
expect_text err "exk-loop: another controller is on $url: process $loop; end it first, or give this one a bus of its own (--url with another port)"
expect_code 0 "$bin/exk-loop" p.ini --fast
expect_code 0 "$bin/exk-loop" p.ini --no-bus -q
kill -INT "$loop"
ends "$loop" 1

# one that holds no claim here, as on another host, is heard
command -v lcm-logplayer >/dev/null || exit 0
expect_code 0 "$bin/exk-loop" "$profiles/rectangle.ini" --fast -r play.lcm
start lcm-logplayer --lcm-url="$url" play.lcm
sleep 0.3
expect_code 2 "$bin/exk-loop" p.ini --url="$url"
expect_part err "exk-loop: another controller speaks on $url: run "
exit 0
