#!/usr/bin/env bash
# mcdc.sh BUILD: lines, branches and MC/DC of the core rooms, after ctest in a build of the preset mcdc
# was run with LLVM_PROFILE_FILE=BUILD/profiles/%4m.profraw. The table goes to stdout, what is not covered
# to BUILD/mcdc.txt.
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
    2>"$build/mcdc.err" | sed "s|$root/||"
llvm-cov-19 show "${common[@]}" --show-mcdc --show-branches=count "${sources[@]}" \
    >"$build/mcdc.txt" 2>>"$build/mcdc.err"
