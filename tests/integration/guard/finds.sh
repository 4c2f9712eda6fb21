#!/usr/bin/env bash
# The guards against an archive that breaks every rule: each must refuse it and name what it found.
# finds.sh NM OBJDUMP IMPURE_ARCHIVE
set -uo pipefail
here=$(dirname "$0")

# refuses WORDS COMMAND...
refuses() {
    local word found
    if found=$("${@:2}" 2>&1); then
        echo "not refused: ${*:2}"
        exit 1
    fi
    for word in $1; do
        if ! grep -qw -- "$word" <<<"$found"; then
            printf 'refused, but %s is not named:\n%s\n' "$word" "$found"
            exit 1
        fi
    done
}

refuses "malloc printf" bash "$here/names.sh" "$1" "$3"
refuses "n_calls n_calls_here" bash "$here/variables.sh" "$2" "$3"
if bash "$here/variables.sh" "$2" "$3" 2>&1 | grep -w names; then
    echo "a constant table was taken for a variable"
    exit 1
fi
