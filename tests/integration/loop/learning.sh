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
python3 - <<'PY' || fail "the error does not fall as (1-K)^(p-1)"
import json, sys
rows = json.load(open("train.json"))["iterations"]
assert [r["iteration"] for r in rows] == [1, 2, 3, 4, 5]
first = rows[0]["last_point_mm"]
assert first > 0.05, first
for p, row in enumerate(rows):
    ratio = row["last_point_mm"] / first / 0.5 ** p
    print(p + 1, row["last_point_mm"], ratio)
    assert abs(ratio - 1) < 0.01, (p, ratio)
PY
