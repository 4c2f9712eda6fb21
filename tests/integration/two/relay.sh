# Lost, late, repeated, reordered, foreign and damaged answers are told apart and counted; none of them
# changes the result of a lock-step run; a paced run goes on without them.
. "$(dirname "$0")/common.sh"
short p.ini -e 's/^\[loop\]/[loop]\nmissed_max = 100000\nbad_max = 100000/'
machine p.ini --url="$url_behind"
expect_code 0 "$bin/exk-loop" p.ini --fast -r one.lcm

# between WHAT N [option...]: a run with the relay between controller and twin; done: how often it did it
between() {
    "$relay" "$url" "$url_behind" "$1" "$2" >relay.out 2>relay.err &
    local id=$! i
    children="$children $id"
    for ((i = 0; i < 100; i++)); do
        grep -q ready relay.out && break
        sleep 0.02
    done
    expect_code 0 "$bin/exk-loop" p.ini --source bus --url="$url" -r two.lcm "${@:3}"
    sleep 0.1 # the bye is on its way
    kill -TERM "$id"
    wait "$id"
    harmed=$(awk -v what="$1" '$1 == what { print $2 }' relay.out)
    [ "$harmed" -gt 0 ] || fail "the relay did nothing"
}

for what in drop repeat swap late foreign garbage; do
    between "$what" 200 --fast
    cmp one.lcm two.lcm || fail "$what changes a lock-step run"
done

between drop 20
expect_count two.lcm lost -ge $((harmed - 1)) # one lost at the very end shows only by its tick
expect_count two.lcm bad -ge "$harmed"
expect_count two.lcm repeated -eq 0
between repeat 20
expect_count two.lcm repeated -ge $((harmed - 1))
expect_count two.lcm lost -eq 0
between swap 20
expect_count two.lcm reordered -ge $((harmed - 1))
expect_count two.lcm late -ge $((harmed - 1))
between late 20
expect_count two.lcm late -ge $((harmed - 1))
between foreign 20
expect_count two.lcm foreign -ge $((harmed - 1))
expect_count two.lcm lost -eq 0
between garbage 20
expect_count two.lcm foreign -ge $((harmed - 1))
exit 0
