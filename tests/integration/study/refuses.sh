#!/usr/bin/env bash
# Damaged, cut, foreign, missing and double parts; wrong options; a profile with a fault.
source "$(dirname "$0")/common.sh"

# refused CODE TEXT ARGUMENTS...
refused() {
    local want=$1 text=$2 code=0
    shift 2
    "$study" "$@" >out 2>said || code=$?
    [[ $code == "$want" ]] || fail "$*: exit $code, wanted $want: $(cat said)"
    grep -qF -- "$text" said || fail "$*: wanted '$text', said: $(cat said)"
}

common=(--profiles "$profiles/study" --only S6)
"$study" block --from 0 --to 50 -o a.bin "${common[@]}"
"$study" block --from 50 --to 100 -o b.bin "${common[@]}"
cp b.bin damaged.bin
printf 'x' | dd of=damaged.bin bs=1 seek=90 conv=notrunc status=none
head -c 200 b.bin >cut.bin
: >empty.bin
"$study" block --from 50 --to 100 -o other.bin --profiles "$profiles/study" --only S5

refused 2 "damaged.bin: refused: damaged: its CRC does not fit" merge a.bin damaged.bin "${common[@]}"
refused 2 "cut.bin: refused: cut" merge a.bin cut.bin "${common[@]}"
refused 2 "empty.bin: refused: it is empty" merge a.bin empty.bin "${common[@]}"
refused 2 "other.bin: refused: of another study" merge a.bin other.bin "${common[@]}"
refused 2 "no part holds the trials from 0 on" merge b.bin "${common[@]}"
refused 2 "a.bin: refused: trials from 0 on are there already" merge a.bin a.bin "${common[@]}"
refused 3 "absent.bin: cannot be read" merge absent.bin "${common[@]}"

mkdir kept
cp damaged.bin kept/block-000001.bin
"$study" paper --seeds 100 --resume kept --json healed.json "${common[@]}" >out 2>said
grep -q "kept/block-000001.bin: refused, it is run again: damaged" said || fail "$(cat said)"
cmp kept/block-000001.bin b.bin
"$study" merge a.bin b.bin --json merged.json "${common[@]}" >out
cmp healed.json merged.json

refused 2 "--seeds 15: a multiple of 10" paper --seeds 15
refused 2 "--only S12" paper --only S12
refused 2 "block needs --from A --to B" block --from 50 --to 50 -o x
refused 2 "unknown command studies" studies
refused 2 "a command is missing"
refused 2 "are not in $work/nowhere" paper --profiles "$work/nowhere"

cp -r "$profiles/study" mine
sed -i 's/^columns = 9/columns = 8/' mine/s9_grid45_white.ini
refused 2 "s9_grid45_white.ini has 40 holes; the study has 45" paper --seeds 10 --profiles mine
sed -i 's/^columns = 8/colums = 9/' mine/s9_grid45_white.ini
refused 2 "s9_grid45_white.ini:" paper --seeds 10 --profiles mine
