# Shared by the scripts here: what loop/common.sh has, and helpers, the folder of argument 3.
. "$(dirname "$0")/../loop/common.sh"
helpers=$3
holes=$bin/exk-holes

# run_log NAME [sed...]: NAME.lcm of a short rectangle, recorded by exk-loop
run_log() {
    local name=$1
    shift
    short "$name.ini" "$@"
    "$bin/exk-loop" "$name.ini" --fast -q -r "$name.lcm" >/dev/null || fail "no log $name.lcm"
}

# edit IN OUT EDIT...: see edit_log.c
edit() { "$helpers/edit-log" "$@" || fail "edit-log $*"; }

quiet_machine=(-e 's/^sigma_rad_per_sqrt_s *=.*/sigma_rad_per_sqrt_s = 1e-9/')
