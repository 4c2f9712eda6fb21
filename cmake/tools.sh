# shellcheck shell=bash disable=SC2154
# Analysers, and the parts of ./check --long, sourced by it. What a part needs and the host does not offer is said and left out.

packages_long=(clang-19 libclang-rt-19-dev llvm-19 clang-tidy-19 frama-c-base valgrind)
fuzz_runs=${EXK_FUZZ_RUNS:-10000000}
core_rooms=(base kinematics plan random noise control plant loop metrics config)
# MISRA C is asked of the rooms that control a machine, not of config, which reads text.
misra_rooms=(base kinematics plan random noise control plant loop metrics)

have() {
    if ! command -v "$1" >/dev/null; then
        note "$2: skipped, $1 is not here"
        return 1
    fi
}

# --- static analysis ---------------------------------------------------------------------------

# Left out: what lcm-gen writes, and a leak that gcc 12 sees in event_reader.c, whose buffer its owner keeps.
run_analyzer() {
    cmake -S . -B build/analyzer -DCMAKE_BUILD_TYPE=RelWithDebInfo -DBUILD_TESTING=OFF \
        -DCMAKE_C_COMPILER=gcc -DCMAKE_C_FLAGS=-fanalyzer
    cmake --build build/analyzer --clean-first -j "$(nproc)" >build/analyzer/all.log 2>&1 || return
    ! grep 'warning:' build/analyzer/all.log |
        grep -v -e 'lcm_types/gen/' -e 'event_reader.c.*-Wanalyzer-malloc-leak'
}

run_tidy() {
    local sources
    cmake --preset mcdc -DBUILD_TESTING=ON -DCMAKE_EXPORT_COMPILE_COMMANDS=ON
    cmake --build --preset mcdc -j "$(nproc)" --target exk_types
    mapfile -t sources < <(grep -o "$exk_root/\(src\|host_tools\|bench\)/[^\" ]*\.c" \
        build/mcdc/compile_commands.json | sort -u) # what is built: not mpi_on.c where there is no MPI
    ((${#sources[@]} > 0)) || return
    printf '%s\0' "${sources[@]}" |
        xargs -0 -P "$(nproc)" -n 4 clang-tidy-19 -p build/mcdc --quiet
}

# Each rule that the core breaks must be a row of docs/misra.md, and each row a rule that it breaks.
run_misra() {
    local rooms=("${misra_rooms[@]/#/src/}")
    cppcheck -q --addon=misra --std=c11 -Iinclude --suppress=missingIncludeSystem \
        --template='{file}:{line}: {id}' "${rooms[@]}" 2>&1 | tee build/misra.log
    grep -o 'misra-c2012-[0-9.]*' build/misra.log | sed 's/misra-c2012-//' | sort -uV >build/misra.found
    sed -n 's/^| \([0-9]*\.[0-9]*\) .*/\1/p' docs/misra.md | sort -uV >build/misra.listed
    echo "rules broken and not in docs/misra.md (<), listed and kept (>):"
    diff build/misra.found build/misra.listed
}

# --- proof, coverage, threads, memory ----------------------------------------------------------

run_mcdc() {
    cmake --preset mcdc -DBUILD_TESTING=ON && cmake --build --preset mcdc -j "$(nproc)" || return
    rm -rf build/mcdc/profiles
    LLVM_PROFILE_FILE=$exk_root/build/mcdc/profiles/%4m.profraw \
        ctest --preset mcdc -j "$(nproc)" -L 'unit|fuzz' && bash cmake/mcdc.sh build/mcdc
}

run_tsan() {
    cmake --preset tsan -DBUILD_TESTING=ON && cmake --build --preset tsan -j "$(nproc)" || return
    TSAN_OPTIONS=suppressions=$exk_root/tests/tsan.supp "${network[@]}" ctest --preset tsan -R \
        '^test_(ring|publisher|bus|run_log|two_same_bytes|two_paced|two_command|bus_late|bus_ends)$'
}

# Not the tests of numbers as text: valgrind's long double has the precision of a double.
run_valgrind() {
    local name
    for name in store event_file run_log wire publisher ring loop loop_states guard ilc; do
        valgrind -q --error-exitcode=9 --leak-check=full --show-leak-kinds=definite,indirect \
            --errors-for-leak-kinds=definite,indirect "build/dev/tests/test_$name" || return
    done
}

# --- long forms of tests ------------------------------------------------------------------------

run_long_forms() {
    local folder name
    for name in detection fault_product odd_moments; do
        EXK_LONG=1 "build/release/tests/test_$name" || return
    done
    folder=$(mktemp -d)
    build/release/tests/exk_killed 10000 "$folder" && rm -r "$folder"
}

# --- fuzzing -----------------------------------------------------------------------------------

# What is new is kept in build/fuzz-corpus; an input that breaks a promise is left in build/fuzz-findings.
fuzz_one() {
    local name=$1 corpus=build/fuzz-corpus/$1
    mkdir -p "$corpus" build/fuzz-findings
    build/fuzz/tests/fuzz_"$name" -runs="$2" -max_len=4096 -timeout=10 -rss_limit_mb=2048 \
        -print_final_stats=1 -artifact_prefix="build/fuzz-findings/$name-" \
        "$corpus" "tests/fuzz/corpus/$name" >"build/fuzz-findings/$name.log" 2>&1 || {
        grep -e 'broken:' -e 'ERROR:' -e 'runtime error' -e 'Test unit' "build/fuzz-findings/$name.log"
        return 1
    }
    sed -n "s/^stat::number_of_executed_units: */$name: /p" "build/fuzz-findings/$name.log"
}

# Slow ones first, as many at a time as there are cores.
run_fuzz() {
    cmake --preset fuzz -DBUILD_TESTING=ON &&
        cmake --build --preset fuzz -j "$(nproc)" --target fuzzers || return
    export -f fuzz_one
    printf '%s\n' profile log loop job_csv store wire kin |
        xargs -P "$(nproc)" -I{} bash -c "fuzz_one {} $fuzz_runs"
}

# tool_step TOOL LABEL COMMAND...: goes on after a failure, so that one run tells all.
tool_step() {
    local needs=$1 label=$2
    shift 2
    have "$needs" "$label" || return 0
    step "$label" "$@" || failed+=("$label")
}

check_quick_tools() {
    tool_step gcc "gcc -fanalyzer" run_analyzer
    tool_step cppcheck "cppcheck, MISRA C:2012" run_misra
}

# About two hours on two cores, most of it fuzzing.
check_long() {
    tool_step clang-tidy-19 "clang-tidy" run_tidy
    tool_step frama-c "Frama-C Eva" bash cmake/proof.sh . build/proof
    cat "$exk_log"
    tool_step llvm-cov-19 "MC/DC of the core" run_mcdc
    grep -e '^TOTAL' -e '^not tested' -e '^docs/coverage' "$exk_log" || true
    tool_step clang-19 "thread sanitizer" run_tsan
    tool_step valgrind "valgrind" run_valgrind
    step "long forms of tests" run_long_forms || failed+=("long forms of tests")
    grep -e '^false' -e '^spikes' -e 'kills,' "$exk_log" || true
    tool_step clang-19 "fuzzing, $fuzz_runs a target" run_fuzz
    cat "$exk_log"
}
