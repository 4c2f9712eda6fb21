#!/usr/bin/env bash
# What the core may ask of its surroundings: maths, mem*, and what a compiler puts in on its own.
# names.sh NM ARCHIVE...  Exit 1 and the names, with their object files, when it asks for more.
# An allow list, because compilers rename: printf("x\n") becomes puts.
set -euo pipefail
nm=$1
shift
maths='sin|cos|tan|asin|acos|atan|atan2|sincos|sqrt|hypot|exp|log|log1p|expm1|pow|cbrt|fma|fabs'
maths+='|floor|ceil|round|trunc|rint|nearbyint|l?lround|l?lrint|fmod|remainder|fmin|fmax|copysign'
maths+='|erf|erfc|ldexp|frexp|nextafter|isnan|isinf|__isnan|__isinf|__finite|__fpclassify'
memory='memcpy|memmove|memset|memcmp|strlen|strcmp|strncmp'
compiler='_GLOBAL_OFFSET_TABLE_|__stack_chk_fail|__memcpy_chk|__memset_chk|__memmove_chk|__mul[st][ic]3'
allowed="^($maths|$memory|$compiler)\$"

defined=$("$nm" --defined-only --extern-only -P "$@" | awk 'NF >= 2 {print $1}' | sort -u)
bad=$("$nm" --undefined-only -P -A "$@" | awk '{print $2, $1}' | sort -u |
    awk -v allowed="$allowed" 'NR == FNR {own[$1]; next} !($1 in own) && $1 !~ allowed' \
        <(printf '%s\n' "$defined") -)
if [[ -z $defined ]]; then
    echo "no symbols found in: $*" >&2
    exit 1
fi
if [[ -n $bad ]]; then
    printf 'the core may not use these names (name, where):\n%s\n' "$bad" >&2
    exit 1
fi
echo "checked $(wc -w <<<"$defined") functions and tables of $# archives"
