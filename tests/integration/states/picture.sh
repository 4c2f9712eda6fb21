# picture.sh PRINTER FOLDER: FOLDER/states.dot is what the table prints, and states.svg draws it.
set -eu
remedy="run: $1 > docs/img/states.dot && dot -Tsvg -o docs/img/states.svg docs/img/states.dot"
"$1" | cmp - "$2/states.dot" || { echo "states.dot is not that of the table; $remedy" >&2; exit 1; }
arrows=$(grep -c -- '->' "$2/states.dot")
drawn=$(grep -c 'class="edge"' "$2/states.svg")
[[ $arrows -eq $drawn ]] || { echo "states.svg draws $drawn of $arrows arrows; $remedy" >&2; exit 1; }
grep -o '<td><font[^>]*>[^<]*' "$2/states.dot" | sed 's/.*>//' | sort -u | while read -r event; do
    sed 's/&#45;/-/g' "$2/states.svg" | grep -qF ">$event<" ||
        { echo "states.svg lacks '$event'; $remedy" >&2; exit 1; }
done
