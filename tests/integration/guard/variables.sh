#!/usr/bin/env bash
# No mutable variable at file scope: nothing of the core may lie in .data, .bss or their thread
# kinds (.data.rel.ro is constant: tables of addresses).
# variables.sh OBJDUMP ARCHIVE...
set -euo pipefail
objdump=$1
shift
symbols=$("$objdump" --syms "$@")
if ! grep -q ' \.text' <<<"$symbols"; then
    echo "no code found in: $*" >&2
    exit 1
fi
bad=$(awk '/^[^ ]+\.o:/ {file = $1}
    { for (i = 2; i < NF; i++)
        if (($i ~ /^\.t?(data|bss)(\.|$)/ && $i !~ /^\.data\.rel\.ro/) || $i == "*COM*")
            if ($NF != $i) print $NF, "in", $i, "of", file }' <<<"$symbols")
if [[ -n $bad ]]; then
    printf 'mutable variables at file scope:\n%s\n' "$bad" >&2
    exit 1
fi
echo "no mutable variable at file scope in $# archives"
