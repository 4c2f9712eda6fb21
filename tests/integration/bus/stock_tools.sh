# LCM's own tools: what lcm-logger records we read, what we record lcm-logplayer plays.
. "$(dirname "$0")/common.sh"
command -v lcm-logger >/dev/null && command -v lcm-logplayer >/dev/null || exit 77
short p.ini -e "s/^rate_Hz *=.*/rate_Hz = 200/" # lcm-logger loses messages at some kHz on a busy host
start lcm-logger --lcm-url="$url" stock.lcm
logger=$started
sleep 0.5
expect_code 0 "$bin/exk-loop" p.ini --url="$url" -r own.lcm
sleep 0.3
kill -INT "$logger"
wait "$logger"
expect_code 0 "$bin/exk-log" --from stock.lcm --csv stock.csv
expect_code 0 "$bin/exk-log" --from own.lcm --csv own.csv
cmp stock.csv own.csv || fail "lcm-logger's log reads otherwise than ours"

recorder played.lcm --until-done --csv played.csv
log=$started
lcm-logplayer --lcm-url="$url" own.lcm >/dev/null 2>&1 || fail "lcm-logplayer does not play our log"
ends "$log" 0
cmp played.csv own.csv || fail "a replay reads otherwise than the log"
exit 0
