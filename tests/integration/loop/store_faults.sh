# A store of another profile, one flipped bit, a cut file: refused with the reason; nothing runs.
. "$(dirname "$0")/common.sh"
short a.ini
short b.ini -e 's/^width_mm *=.*/width_mm = 40/'
expect_code 0 "$bin/exk-ilc" train a.ini -n 2 -o a.ilc
expect_code 2 "$bin/exk-loop" b.ini --fast --ilc a.ilc -r b.lcm
expect_part err "a.ilc: ILC store of another job: its hash is "
expect_part err "; train a store for this [machine], [kinematics], [job] and rate"
[ -e b.lcm ] && fail "a log was started for a refused store"

# seed, noise, gains and telemetry may change
sed 's/^seed *=.*/seed = 99/; s/^ki_per_s *=.*/ki_per_s = 1/' a.ini >other_seed.ini
expect_code 0 "$bin/exk-loop" other_seed.ini --fast --ilc a.ilc -r ok.lcm

cp a.ilc bit.ilc
printf '\x55' | dd of=bit.ilc bs=1 seek=200 conv=notrunc status=none
expect_code 2 "$bin/exk-loop" a.ini --fast --ilc bit.ilc -r c.lcm
expect_part err "bit.ilc: damaged ILC store: CRC-32 is "
head -c 100 a.ilc >cut.ilc
expect_code 2 "$bin/exk-ilc" verify cut.ilc
expect_part err "cut.ilc: damaged ILC store: CRC-32 is "
echo hello >text.ilc
expect_code 2 "$bin/exk-ilc" show text.ilc
expect_text err "exk-ilc: text.ilc: not an ILC store (no EXKILC at its start)"
expect_code 2 "$bin/exk-ilc" train a.ini -n 1 -o text.ilc
expect_text err "exk-ilc: text.ilc: exists and is not an ILC store: not overwritten; choose another name"
exit 0
