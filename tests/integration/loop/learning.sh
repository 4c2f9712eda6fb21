# Frozen noise, K = 0.5: trained through logs and in process, alike to the last bit, and the
# last-point error falls as (1-K)^(p-1) within 1 %.
. "$(dirname "$0")/common.sh"
profile="$profiles/rectangle_ilc.ini"
expect_code 0 "$bin/exk-ilc" train "$profile" -n 5 -o inside.ilc --json
cp out train.json
expect_code 0 "$bin/exk-loop" "$profile" --fast -r 1.lcm
expect_code 0 "$bin/exk-ilc" learn 1.lcm -o log.ilc
for p in 2 3 4 5; do
    expect_code 0 "$bin/exk-loop" "$profile" --fast --ilc log.ilc -r $p.lcm
    expect_code 0 "$bin/exk-ilc" learn $p.lcm -o log.ilc
    expect_part out "learned from run $p of rectangle_ilc"
done
cmp inside.ilc log.ilc || fail "trained through logs and in process differ"
expect_code 0 "$bin/exk-ilc" show log.ilc
expect_text out "for run     6"
expect_code 0 "$bin/exk-ilc" verify log.ilc "$profile"
awk '/"iteration":/ {p++; if ($2 != p ",") exit 1}
    /"last_point_mm":/ {
        error = $2 + 0
        if (p == 1) first = error
        ratio = error / first / 0.5 ^ (p - 1)
        print p, error, ratio
        if (!(first > 0.05 && ratio > 0.99 && ratio < 1.01)) exit 1
        n++
    }
    END { if (n != 5) exit 1 }' train.json || fail "the error does not fall as (1-K)^(p-1)"

# A series that is stopped keeps what it has learned: that of the runs on the table, to the bit.
for signal in INT TERM; do
    : >table.$signal
    "$bin/exk-ilc" train "$profile" -n 100000 -o stopped.ilc >table.$signal 2>err &
    pid=$!
    while kill -0 $pid && [ "$(wc -l <table.$signal)" -le 4 ]; do sleep 0.05; done
    kill -$signal $pid
    code=0
    wait $pid || code=$?
    [ $code -eq 1 ] || { cat err >&2; fail "SIG$signal: exit code $code, not 1"; }
    runs=$(($(wc -l <table.$signal) - 2))
    expect_part err "after run $runs of 100000"
    expect_code 0 "$bin/exk-ilc" train "$profile" -n $runs -o whole.ilc
    cmp stopped.ilc whole.ilc || fail "SIG$signal: the store is not that of $runs runs"
done
