# Shared by the scripts here: bin and profiles are arguments 1 and 2, work is a folder of its own.
set -u
bin=$1
profiles=$2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work" || exit 1

fail() { echo "FAIL: $*" >&2; exit 1; }

# expect_code N command...: runs it, output to out and err, and wants exit code N
expect_code() {
    local want=$1 got=0
    shift
    "$@" >out 2>err </dev/null || got=$?
    [ "$got" -eq "$want" ] || { cat out err >&2; fail "$* ended with $got, not $want"; }
}

# expect_text FILE TEXT: FILE holds the line TEXT, to the letter
expect_text() { grep -qxF -- "$2" "$1" || { cat "$1" >&2; fail "$1 lacks: $2"; }; }

# expect_part FILE TEXT: TEXT stands somewhere in FILE
expect_part() { grep -qF -- "$2" "$1" || { cat "$1" >&2; fail "$1 lacks: $2"; }; }

# short NAME [sed...]: a copy of the rectangle profile that takes 1.2 s of machine time
short() {
    sed -e 's/^width_mm *=.*/width_mm = 30/' -e 's/^height_mm *=.*/height_mm = 20/' \
        -e 's/^dwell_s *=.*/dwell_s = 0.05/' "${@:2}" "$profiles/rectangle.ini" >"$1"
}
