# Same profile and seed: the same log to the byte; another seed, series or run: another one.
. "$(dirname "$0")/common.sh"
short p.ini -e 's/^repeat *=.*/repeat = fresh/'
for f in a b; do
    expect_code 0 "$bin/exk-loop" p.ini --fast --record $f.lcm
done
cmp a.lcm b.lcm || fail "two runs of one profile and seed differ"
expect_code 0 "$bin/exk-loop" p.ini --fast --record run2.lcm --run 2
expect_code 0 "$bin/exk-loop" p.ini --fast --record series1.lcm --series 1
cmp -s a.lcm run2.lcm && fail "run 2 of a fresh noise is the same as run 1"
cmp -s a.lcm series1.lcm && fail "series 1 is the same as series 0"
exit 0
