#!/usr/bin/env bash
# Ctrl-C: exit 1, finished blocks kept, the command that goes on is said and does go on.
source "$(dirname "$0")/common.sh"
run paper --seeds 400 -j 2 --json whole.json
"$study" paper --seeds 400 -j 1 --only S5,S6 --profiles "$profiles/study" --json got.json \
    --resume got.json.parts >/dev/null 2>said &
pid=$!
# stopped when the first of its eight blocks is done, whatever the speed of the machine
until [[ -e got.json.parts/block-000000.bin ]]; do
    kill -0 "$pid" || fail "ended before its first block: $(cat said)"
    sleep 0.01
done
kill -INT "$pid"
code=0
wait "$pid" || code=$?
[[ $code == 1 ]] || fail "exit $code after Ctrl-C, wanted 1"
[[ ! -e got.json ]] || fail "a result was written"
grep -q "stopped with" said || fail "did not say where it stopped: $(cat said)"
if grep -q "kept in got.json.parts" said; then
    ls got.json.parts/block-000000.bin >/dev/null
    grep -q "exk-study paper --seeds 400 --only S5,S6 --resume got.json.parts" said ||
        fail "the command is not said: $(cat said)"
fi
run paper --seeds 400 -j 2 --resume got.json.parts --json got.json
cmp whole.json got.json
