#!/usr/bin/env bash
# -j 1, -j 2, brief or step by step, four parts merged in any order, mpirun: the same JSON and CSV, byte for byte.
source "$(dirname "$0")/common.sh"
run paper --seeds 110 -j 1 --json one.json --csv one.csv
run paper --seeds 110 -j 2 --json two.json --csv two.csv
cmp one.json two.json && cmp one.csv two.csv
run paper --seeds 110 -j 2 --steps --json steps.json --csv steps.csv
cmp one.json steps.json && cmp one.csv steps.csv

for from in 0 50 100; do
    to=$((from + 50 < 110 ? from + 50 : 110))
    run block --from "$from" --to "$to" -o "part$from.bin"
done
run merge part100.bin part0.bin part50.bin --json merged.json
cmp one.json merged.json
run block --from 50 --to 110 -o rest.bin -j 2
run merge rest.bin part0.bin --json two_parts.json
cmp one.json two_parts.json

if command -v mpirun >/dev/null && ldd "$study" 2>/dev/null | grep -q libmpi; then
    export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
    export OMPI_MCA_rmaps_base_oversubscribe=1
    # Open MPI leaves memory behind at its end; ours is looked at above.
    ASAN_OPTIONS=detect_leaks=0 mpirun -n 2 "$study" paper --seeds 110 --profiles "$profiles/study" --only S5,S6 \
        --json ranks.json >/dev/null
    cmp one.json ranks.json
else
    echo "no mpirun, or exk-study without MPI: ranks not tried"
fi
