#!/bin/sh
# Puts the examples of PROGRAM --help into its man PAGE as they stand, a line each: help2man would fill them
# into a paragraph. examples.sh PROGRAM PAGE
set -eu
program=$1
page=$2
"$program" --help | awk '/^Examples?:$/ { on = 1; next } on && /^$/ { exit }
    on { gsub(/\\/, "\\e"); gsub(/-/, "\\-"); sub(/^  /, ""); print }' >"$page.examples"
awk -v examples="$page.examples" '
    /^\.SH EXAMPLES?$/ {
        print ".SH EXAMPLES\n.nf"
        while ((getline line < examples) > 0) print line
        print ".fi"
        skipped = 1
        next
    }
    skipped && (/^\.PP$/ || /^\.SH/) { skipped = 0 }
    !skipped' "$page" >"$page.whole"
mv "$page.whole" "$page"
rm "$page.examples"
