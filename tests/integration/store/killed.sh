# killed.sh PROGRAM N: N kills while saving, in a folder of its own
set -eu
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
"$1" "$2" "$work"
