# The loop thread allocates nothing while it runs: counted by a preloaded malloc. heap.sh BIN PROFILES LIB
. "$(dirname "$0")/../loop/common.sh"
sed -e 's/^columns *=.*/columns = 2/' -e 's/^rows *=.*/rows = 1/' -e 's/^drill_mmps *=.*/drill_mmps = 50/' \
    -e 's/^width_mm *=.*/width_mm = 20/' -e 's/^dwell_s *=.*/dwell_s = 0.1/' \
    -e 's/^\[loop\]/[loop]\nmissed_max = 100000/' "$profiles/machine.ini" >p.ini
LD_PRELOAD=$3 "$bin/exk-loop" p.ini --no-bus -r run.lcm >out 2>err || fail "exk-loop ended with $?"
grep 'heap calls in the loop' err || { cat err >&2; fail "the counter did not report"; }
expect_part err "heap calls in the loop: 0 in "
waits=$(sed -n 's/.*loop: 0 in \([0-9]*\) waits/\1/p' err)
[ "$waits" -ge 1000 ] || fail "only $waits waits were seen"
