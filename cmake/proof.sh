#!/usr/bin/env bash
# proof.sh SOURCE_DIR BUILD_DIR: Frama-C Eva over the drivers in tests/proof. Good: no alarm, and every
# assertion of the driver valid. One line a driver on stdout, Eva's whole text in BUILD_DIR/proof-*.log.
set -euo pipefail
cd "$1"
logs=$2
mkdir -p "$logs"

prove() {
    local name=$1 log=$logs/proof-$1.log
    shift
    frama-c -eva -c11 -warn-special-float none -eva-precision 6 -eva-slevel 400 \
        -eva-split-return auto -eva-auto-loop-unroll 64 \
        -cpp-extra-args="-Iinclude -Itests/proof -std=c11 -include tests/proof/finite.h" \
        "$@" "tests/proof/$name.c" >"$log" 2>&1 || true
    local asked
    asked=$(sed -n 's/^ *Assertions *\([0-9]* valid.*\) total$/\1/p' "$log")
    if ! grep -q ' 0 alarms generated' "$log" ||
        ! [[ $asked =~ ^[1-9][0-9]*\ valid\ +0\ unknown\ +0\ invalid ]]; then
        printf '%s: NOT proven: %s\n' "$name" "$log"
        grep -A 2 'eva:alarm\|User Error' "$log" || true
        return 1
    fi
    printf '%s: no alarm, assertions: %s\n' "$name" "$(tr -s ' ' <<<"$asked")"
}

bad=0
prove pi src/control/pid.c || bad=1
prove ilc src/control/ilc.c || bad=1
prove guard src/loop/guard.c src/loop/guard_spike.c || bad=1
prove state src/loop/state.c || bad=1
exit "$bad"
