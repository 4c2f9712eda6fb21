#!/usr/bin/env bash
# What every program does alike: options.sh PROGRAM VERSION
set -uo pipefail
program=$1
name=$(basename "$program")

fail() {
    printf '%s: %s\n' "$name" "$1"
    exit 1
}

help=$("$program" --help 2>/dev/null </dev/null) || fail "--help ends with $?"
grep -qi 'example' <<<"$help" || fail "--help shows no example"
grep -q "$name.*[[:alnum:]./]" < <(grep -i -A 4 'example' <<<"$help") ||
    fail "the example does not call $name"
said=$("$program" --version 2>/dev/null </dev/null) || fail "--version ends with $?"
[[ $said == *"$name"*"$2"* ]] || fail "--version says '$said', wanted '$name ... $2'"
found=$("$program" --no-such-option 2>&1 >/dev/null </dev/null)
rc=$?
((rc == 2)) || fail "an unknown option ends with $rc, wanted 2"
grep -q 'no-such-option' <<<"$found" || fail "the message does not name the unknown option: $found"

# No line is wider than a terminal, and none was broken by the option parser where nobody meant it: given room,
# it prints the same lines. (It fills the texts of the options itself, and says one sentence of its own.)
awk 'length > 79 { print; wide = 1 } END { exit wide }' <<<"$help" || fail "--help has lines above 79 columns"
wide=$(ARGP_HELP_FMT=rmargin=250 "$program" --help </dev/null)
own='^ +-|^ {24,}|^Mandatory or optional arguments|^for any corresponding short options'
broken=$(grep -vE "$own" <<<"$help" | grep -vxFf <(printf '%s\n' "$wide"))
[[ -z $broken ]] || fail "--help has broken lines:"$'\n'"$broken"
