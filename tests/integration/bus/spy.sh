# The spy's launcher: what it needs and says; the types jar holds every type of the bus.
. "$(dirname "$0")/common.sh"
jar=$bin/../share/exk/exk_types.jar
mkdir empty
ln -s "$(command -v dirname)" "$(command -v cat)" empty/
expect_code 3 env PATH="$PWD/empty" /bin/sh "$bin/exk-spy"
expect_text err "exk-spy: java is not here: apt-get install default-jre"
[ -r "$jar" ] && command -v java >/dev/null || exit 77
expect_code 3 env -u DISPLAY -u WAYLAND_DISPLAY "$bin/exk-spy" --url="$url"
expect_part err "exk-spy: no display"
for type in "$profiles"/../lcm_types/*.lcm; do
    grep -q "exk/$(basename "$type" .lcm).class" "$jar" || fail "$type is not in the jar"
done
exit 0
