# A store of another profile, one flipped bit, a cut file: refused with the reason; nothing runs.
. "$(dirname "$0")/common.sh"
short a.ini
short b.ini -e 's/^width_mm *=.*/width_mm = 40/'
expect_code 0 "$bin/exk-ilc" train a.ini -n 2 -o a.ilc
expect_code 0 "$bin/exk-ilc" train b.ini -n 1 -o b.ilc
hash_of() { "$bin/exk-ilc" show "$1" | sed -n 's/^job hash *//p'; }
another="a.ilc: ILC store of another job: its hash is $(hash_of a.ilc), this profile's $(hash_of b.ilc); train a store for this [machine], [kinematics], [job] and rate"
expect_code 2 "$bin/exk-loop" b.ini --fast --ilc a.ilc -r b.lcm
expect_text err "$another"
expect_code 2 "$bin/exk-ilc" verify a.ilc b.ini
expect_text err "$another"
[ -e b.lcm ] && fail "a log was started for a refused store"

# seed, noise, gains and telemetry may change
sed 's/^seed *=.*/seed = 99/; s/^ki_per_s *=.*/ki_per_s = 1/' a.ini >other_seed.ini
expect_code 0 "$bin/exk-loop" other_seed.ini --fast --ilc a.ilc -r ok.lcm

# one flipped bit in the header, in the payload and in the CRC-32; then a cut
flip='import sys; d = bytearray(open("a.ilc", "rb").read()); d[int(sys.argv[1])] ^= 16; open("bit.ilc", "wb").write(d)'
sums='import sys, zlib; d = open(sys.argv[1], "rb").read(); print("CRC-32 is %08x, its end says %08x" % (zlib.crc32(d[:-4]), int.from_bytes(d[-4:], "little")))'
damaged() { echo "$1: damaged ILC store: $(python3 -c "$sums" "$1"); train again or restore a copy of the file"; }
for at in 9 20 200 $(($(stat -c %s a.ilc) - 1)); do
    python3 -c "$flip" "$at"
    expect_code 2 "$bin/exk-loop" a.ini --fast --ilc bit.ilc -r c.lcm
    expect_text err "$(damaged bit.ilc)"
done
[ -e c.lcm ] && fail "a log was started for a damaged store"
# with a previous generation: said, and the run goes on with it; verify ends with 1
cp a.ilc two.ilc
expect_code 0 "$bin/exk-ilc" train a.ini -n 1 -o two.ilc
cp bit.ilc two.ilc
before="; its previous generation is used: two.ilc.prev"
why=$(damaged two.ilc)
expect_code 0 "$bin/exk-loop" a.ini --fast --ilc two.ilc -r c.lcm
expect_text err "exk-loop: ${why%; train again*}$before"
expect_code 1 "$bin/exk-ilc" verify two.ilc
expect_text err "exk-ilc: ${why%; train again*}$before"

head -c 100 a.ilc >cut.ilc
expect_code 2 "$bin/exk-ilc" verify cut.ilc
expect_text err "exk-ilc: $(damaged cut.ilc)"
echo hello >text.ilc
expect_code 2 "$bin/exk-ilc" show text.ilc
expect_text err "exk-ilc: text.ilc: not an ILC store (no EXKILC at its start)"
expect_code 2 "$bin/exk-ilc" train a.ini -n 1 -o text.ilc
expect_text err "exk-ilc: text.ilc: exists and is not an ILC store: not overwritten; choose another name"

# an empty file is nobody's work: refused as a store, but saved over
: >empty.ilc
expect_code 2 "$bin/exk-ilc" verify empty.ilc
expect_text err "exk-ilc: empty.ilc: damaged ILC store: it is empty; train again or restore a copy of the file"
expect_code 0 "$bin/exk-ilc" train a.ini -n 1 -o empty.ilc
expect_code 0 "$bin/exk-ilc" verify empty.ilc a.ini

# several that save at once take turns: none fails, nothing is torn or lost
for _ in 1 2 3 4 5 6 7 8; do
    savers=
    for n in 1 2 3 4; do
        "$bin/exk-ilc" train a.ini -n $n -o race.ilc >/dev/null 2>race$n.err &
        savers="$savers $!"
    done
    for saver in $savers; do
        wait "$saver" || { cat race?.err >&2; fail "one of four savers failed"; }
    done
    expect_code 0 "$bin/exk-ilc" verify race.ilc a.ini
done
expect_code 0 "$bin/exk-ilc" verify race.ilc.prev a.ini

# what cannot be a store at all: said, and nothing waits for a FIFO, as the store or as its previous one
mkdir folder.ilc
mkfifo fifo.ilc fifo_before.ilc.prev
cp bit.ilc fifo_before.ilc
for what in folder.ilc fifo.ilc /dev/null; do
    expect_code 3 timeout 10 "$bin/exk-ilc" show "$what"
    expect_text err "exk-ilc: $what: not a regular file: an ILC store is kept in one"
    expect_code 3 timeout 10 "$bin/exk-loop" a.ini --fast --ilc "$what" -r never.lcm
    expect_text err "$what: not a regular file: an ILC store is kept in one"
    expect_code 2 timeout 10 "$bin/exk-ilc" train a.ini -n 1 -o "$what"
    expect_text err "exk-ilc: $what: exists and is not an ILC store: not overwritten; choose another name"
done
expect_code 2 timeout 10 "$bin/exk-ilc" show fifo_before.ilc
expect_part err "; its previous generation is no better: fifo_before.ilc.prev: not a regular file"
expect_code 3 "$bin/exk-loop" a.ini --fast --ilc missing.ilc -r never.lcm
expect_text err "missing.ilc: cannot open the ILC store: No such file or directory"
expect_code 3 "$bin/exk-ilc" train a.ini -n 1 -o no/such/folder.ilc
expect_text err "exk-ilc: no/such/folder.ilc: cannot write the ILC store: No such file or directory"
[ -e never.lcm ] && fail "a log was started for a store that is not there"
exit 0
