# shellcheck shell=bash disable=SC2154
# Set-up shared by ./drill and ./check. Sourced by bash, never run; exk_root and exk_logs are set.
# Notes go to stderr; a step's own output goes to a log that is shown only when the step fails.

exk_job=""      # process group of the step that runs now
exk_children=() # process groups of what runs beside the steps

note() {
    printf '%s\n' "$*" >&2
}

# die CODE TEXT...: exit codes are those of the programs (2 wrong use, 3 input or output failed).
die() {
    local code=$1
    shift
    printf '%s: %s\n' "$exk_me" "$*" >&2
    exit "$code"
}

# In a process group of its own, so that all of it can be stopped; sets exk_started.
start_group() {
    set -m
    "$@" &
    exk_started=$!
    set +m
}

stop_group() {
    if kill -TERM -- "-$1" 2>/dev/null; then
        wait "$1" 2>/dev/null || true
    fi
}

clean_up() {
    local group
    for group in $exk_job "${exk_children[@]}"; do
        stop_group "$group"
    done
    exk_job=""
    exk_children=()
}

stop_all_on_exit() {
    trap 'clean_up' EXIT
    trap 'note ""; note "$exk_me: stopped"; exit 130' INT
    trap 'exit 143' TERM HUP
}

# Seconds that pass, on a terminal only.
show_time() {
    local begin=$SECONDS
    while kill -0 "$exk_job" 2>/dev/null; do
        printf '\r%-40s %5s s' "$1" "$((SECONDS - begin))" >&2
        sleep 0.2
    done
    printf '\r' >&2
}

# What failed tests said, or the last lines of another log.
show_failure() {
    note "--- from ${2#"$exk_root"/}, which has the whole of it:"
    if grep -q '\*\*\*' "$2"; then
        awk '/Test +#/ {on = /\*\*\*/ && !/Skipped/} / Start / || /tests passed/ {on = 0} on' "$2" |
            head -n 80 >&2
    else
        tail -n 25 "$2" >&2
    fi
    note "---"
}

# step LABEL COMMAND...: one line with the time it took; exk_log is where its output went.
step() {
    local label=$1 begin=$SECONDS rc=0
    shift
    mkdir -p "$exk_logs"
    exk_log=$exk_logs/${label//[^A-Za-z0-9]/_}.log
    start_group "$@" >"$exk_log" 2>&1 </dev/null
    exk_job=$exk_started
    if [[ -t 2 ]]; then
        show_time "$label"
    fi
    wait "$exk_job" || rc=$?
    exk_job=""
    if ((rc != 0)); then
        note "$(printf '%-40s FAILED (%d)' "$label" "$rc")"
        show_failure "$label" "$exk_log"
        return "$rc"
    fi
    note "$(printf '%-40s %5d s' "$label" "$((SECONDS - begin))")"
}

is_installed() {
    [[ $(dpkg-query -W -f='${db:Status-Status}\n' "$1" 2>/dev/null | head -n 1) == installed ]]
}

is_offered() {
    [[ -n $(apt-cache madison "$1" 2>/dev/null) ]]
}

# The names among the arguments that are not installed.
missing_of() {
    local name
    for name in "$@"; do
        is_installed "$name" || printf '%s\n' "$name"
    done
}

need_debian() {
    local tool
    for tool in apt-get apt-cache dpkg-query; do
        command -v "$tool" >/dev/null ||
            die 2 "this system has no $tool: only Debian 12 and its like are set up by this script." \
                "Install by hand what these Debian packages hold: $*; then build with" \
                "'cmake --preset release && cmake --build --preset release'."
    done
}

# Sets exk_root_rights to what goes before a command that needs root.
get_rights() {
    exk_root_rights=()
    if ((EUID == 0)); then
        return
    fi
    if ! command -v sudo >/dev/null || ! sudo -v; then
        die 2 "not root, and sudo is not there or refuses. Ask the administrator for:" \
            "apt-get install --no-install-recommends $*"
    fi
    exk_root_rights=(sudo -n)
}

apt_install() {
    "${exk_root_rights[@]}" env DEBIAN_FRONTEND=noninteractive apt-get \
        -o DPkg::Lock::Timeout=120 install -y --no-install-recommends "$@"
}

# need_packages NAME...: installs what is missing, after saying so. Without any missing, no network.
need_packages() {
    local missing
    need_debian "$@"
    mapfile -t missing < <(missing_of "$@")
    if ((${#missing[@]} == 0)); then
        return
    fi
    note "$exk_me: these Debian packages will be installed: ${missing[*]}"
    get_rights "${missing[@]}"
    step "package lists" "${exk_root_rights[@]}" apt-get -o DPkg::Lock::Timeout=120 update ||
        note "$exk_me: some package lists could not be read; going on with those that could"
    step "packages" apt_install "${missing[@]}" ||
        die 3 "the packages could not be installed (no network, or not Debian 12?): ${missing[*]}"
}

# The packages among the arguments that this system offers or has; the others are said.
offered_of() {
    local name
    for name in "$@"; do
        if is_installed "$name" || is_offered "$name"; then
            printf '%s\n' "$name"
        else
            note "$exk_me: $name is not offered here; what needs it will be left out"
        fi
    done
}
