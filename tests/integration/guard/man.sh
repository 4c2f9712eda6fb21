# The man page of a program shows its examples a line each, as --help has them, and says what it is in a line.
# man.sh PROGRAM PAGE; skipped where no pages are made (no help2man).
set -uo pipefail
program=$1
page=$2
[ -e "$page" ] || exit 77
fail() { echo "$(basename "$page"): $1" >&2; exit 1; }
grep -q '^\.SH NAME' "$page" || fail "no name"
examples=$("$program" --help | awk '/^Examples?:$/ { on = 1; next } on && /^$/ { exit } on')
[ -n "$examples" ] || fail "--help has no examples"
plain=$(sed -n '/^\.nf$/,/^\.fi$/p' "$page" | sed 's/\\-/-/g; s/\\e/\\/g')
while IFS= read -r line; do
    grep -qxF -- "${line#  }" <<<"$plain" || fail "lacks the example: $line"
done <<<"$examples"
