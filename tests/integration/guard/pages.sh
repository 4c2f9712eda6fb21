# Every page that a page or a comment names is in the tree: no reader is sent to a file that is not there.
# Argument 1: the root of the source tree.
set -u
cd "$1" || exit 1
missing=0
# the name of a page, with its folder if it is given, as written after a blank, a bracket or a quote
names() { grep -oE '(^|[ (`"])(\.\./)*([A-Za-z0-9_-]+/)*[A-Za-z0-9_-]+\.md' "$1" | sed 's/^[ (`"]//' | sort -u; }
while IFS= read -r file; do
    for name in $(names "$file"); do
        [ -e "$name" ] || [ -e "$(dirname "$file")/$name" ] && continue
        echo "FAIL: $file names $name, which is not there" >&2
        missing=1
    done
done < <(find ./*.md docs include src host_tools bench tests profiles lcm_types -type f \
    \( -name '*.md' -o -name '*.[ch]' -o -name '*.ini' -o -name '*.lcm' \))
exit $missing
