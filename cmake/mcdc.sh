#!/usr/bin/env bash
# mcdc.sh BUILD: lines, branches and MC/DC of the core rooms, after ctest in a build of the preset mcdc
# was run with LLVM_PROFILE_FILE=BUILD/profiles/%4m.profraw. The table goes to stdout, then what no test
# reaches although docs/coverage.md does not list it; with any such the exit status is 1.
set -euo pipefail
build=$1
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
rooms=(base kinematics plan random noise control plant loop metrics config)

is_binary() {
    [[ $(head -c 4 "$1" | tr -d '\0') == $'\x7fELF' ]]
}

objects=()
sources=("$root/include/exk")
while IFS= read -r -d '' program; do
    if is_binary "$program"; then
        objects+=(--object "$program")
    fi
done < <(find "$build/tests" "$build/bin" -maxdepth 1 -type f -executable -print0 | sort -z)
for room in "${rooms[@]}"; do
    sources+=("$root/src/$room")
done
common=(-instr-profile "$build/all.profdata" "${objects[@]:1}")

llvm-profdata-19 merge -sparse -o "$build/all.profdata" "$build"/profiles/*.profraw
llvm-cov-19 report "${common[@]}" --show-mcdc-summary --show-region-summary=false "${sources[@]}" \
    2>"$build/mcdc.err" | sed -e "s|$root/||" -e '/^Files which contain no functions/,/^---/d'
llvm-cov-19 show "${common[@]}" --show-mcdc --show-branches=count \
    "${sources[@]}" >"$build/mcdc.txt" 2>>"$build/mcdc.err"

# FILE:LINE: what is missing: the line. What is inline in a header is shown once for each source that has
# it, and tested when one of them is. Enumerators that a switch only names are no branch of ours.
awk -v root="$root/" '
    /^ *\/.*\.[ch]:$/ { file = substr($0, index($0, root) + length(root)); sub(/:$/, "", file); next }
    match($0, /^ *[0-9]+\|/) {
        split($0, part, "|")
        at = part[1] + 0
        text[file, at] = substr($0, length(part[1]) + length(part[2]) + 3)
        if (part[2] ~ /[0-9]/ && text[file, at] !~ /^ *[{}]* *$|#define/) {
            note(at, 0, "line", part[2] !~ /^ *0$/)
        }
    }
    /Branch \([0-9]+:[0-9]+\): \[True: .*False: / {
        split($0, part, /[(:) ]+/)
        place = $0; sub(/.*Branch \(/, "", place); split(place, part, /[:)]/)
        note(part[1] + 0, part[2] + 0, "never true", $0 !~ /\[True: 0,/)
        note(part[1] + 0, part[2] + 0, "never false", $0 !~ /False: 0\]/)
    }
    /MC\/DC Decision Region \(/ {
        place = $0; sub(/.*Region \(/, "", place); split(place, part, /[:)]/); at = part[1] + 0
        column = part[2] + 0
    }
    /C[0-9]+-Pair: / {
        what = $0; sub(/.*C/, "C", what); sub(/-Pair.*/, "", what)
        note(at, column, "MC/DC " what, $0 !~ /not covered/)
    }
    function note(at, column, what, good,    key) {
        key = file SUBSEP at SUBSEP column SUBSEP what
        seen[key] = seen[key] || good
    }
    END {
        for (key in seen) {
            split(key, part, SUBSEP)
            line = text[part[1], part[2]]; sub(/^ +/, "", line)
            if (!seen[key] && line !~ /^switch |^case /) {
                printf "%s:%d: %s: %s\n", part[1], part[2], part[4], line
            }
        }
    }' "$build/mcdc.txt" | sort -u -t: -k1,1 -k2,2n -k3 >"$build/missing.txt"

# Rows of the list: | `file` | `code` | reason |; a missing line is excused when it holds the code.
awk -v list="$root/docs/coverage.md" '
    BEGIN {
        while ((getline row < list) > 0) {
            if (split(row, cell, "`") >= 5) {
                gsub(/\\\|/, "|", cell[4])
                file[++n] = cell[2]; code[n] = cell[4]
            }
        }
    }
    {
        for (i = 1; i <= n; i++) {
            if (index($0, file[i] ":") == 1 && index($0, code[i]) > 0) { used[i] = 1; next }
        }
        print "not tested: " $0; bad = 1
    }
    END {
        for (i = 1; i <= n; i++) {
            if (!used[i]) print "docs/coverage.md: " file[i] ": is tested, or gone: " code[i]
        }
        exit bad
    }' "$build/missing.txt"
