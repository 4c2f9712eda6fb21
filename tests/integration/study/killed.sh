#!/usr/bin/env bash
# Killed twenty times at random moments and resumed each time: the result of an undisturbed run.
source "$(dirname "$0")/common.sh"
run paper --seeds 400 -j 2 --json whole.json
for i in $(seq 20); do
    "$study" paper --seeds 400 -j 2 --only S5,S6 --profiles "$profiles/study" --resume kept \
        --json resumed.json >/dev/null 2>>notes &
    pid=$!
    sleep "0.$((RANDOM % 25 + 10))"
    kill -KILL "$pid" 2>/dev/null || true
    wait "$pid" 2>/dev/null || true
done
rm -f kept/*.??????
run paper --seeds 400 -j 2 --resume kept --json resumed.json
cmp whole.json resumed.json
if grep -q refused notes; then
    fail "a killed run left a block that is not whole"
fi
