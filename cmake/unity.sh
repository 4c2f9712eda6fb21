# shellcheck shell=bash disable=SC2154
# Unity, the test framework, from the Debian source package ntpsec, which carries it. Sourced.
# Lists and cache are private, the mirror is the machine's own, nothing of the machine changes.

unity_package=ntpsec
unity_tarball=ntpsec_1.2.2+dfsg1.orig.tar.xz
unity_sha256=53e527e3d04d551d41af2d359c2715c2de5f5bfa2a695d4ec1a811b3e9137f63

# One-line entries ("deb [options] uri suite component...") of Debian's main suite, as deb-src.
list_entries() {
    awk -v suites="$1" '
        function wanted(suite) { return index(" " suites " ", " " suite " ") }
        /^[ \t]*deb[ \t]/ {
            sub(/#.*/, ""); sub(/^[ \t]*deb[ \t]+/, ""); options = ""
            if (match($0, /^\[[^]]*\][ \t]*/)) {
                options = substr($0, 1, RLENGTH); $0 = substr($0, RLENGTH + 1)
            }
            if ($1 !~ /^cdrom:/ && wanted($2) && / main( |$)/) print "deb-src " options $1, $2, "main"
        }' "${@:2}"
}

# Entries of deb822 files (stanzas of "Key: value"), as deb-src.
stanza_entries() {
    awk -v suites="$1" '
        function has(list, word) { return index(" " list " ", " " word " ") }
        function words(key) { gsub(/[ \t\n]+/, " ", value[key]); return value[key] }
        function finish(    i, n, suite, chosen) {
            n = split(words("suites"), suite, " ")
            for (i = 1; i <= n; i++) if (has(suites, suite[i])) chosen = chosen " " suite[i]
            if (has(words("types"), "deb") && has(words("components"), "main") && chosen != "" &&
                words("enabled") !~ /no/ && words("uris") !~ /cdrom:/) {
                print "Types: deb-src\nURIs: " words("uris") "\nSuites:" chosen "\nComponents: main"
                if ("signed-by" in value) print "Signed-By:" value["signed-by"]
                if ("trusted" in value) print "Trusted:" value["trusted"]
                print ""
            }
            split("", value)
        }
        FNR == 1 { finish() }
        /^#/ { next }
        /^[ \t]*$/ { finish(); next }
        /^[ \t]/ { value[key] = value[key] "\n" $0; next }
        { key = tolower(substr($0, 1, index($0, ":") - 1)); value[key] = substr($0, index($0, ":") + 1) }
        END { finish() }' "${@:2}"
}

# unity_entries DIR: writes the machine's Debian entries to DIR as entries for source packages.
unity_entries() {
    local Dir_list Dir_parts suites
    eval "$(apt-config shell Dir_list Dir::Etc::SourceList/f Dir_parts Dir::Etc::SourceParts/d)"
    suites="$(. /etc/os-release && printf '%s' "${VERSION_CODENAME:-}") stable oldstable"
    shopt -s nullglob
    local lists=("$Dir_parts"/*.list) stanzas=("$Dir_parts"/*.sources)
    shopt -u nullglob
    if [[ -s $Dir_list ]]; then
        lists+=("$Dir_list")
    fi
    mkdir -p "$1"
    list_entries "$suites" "${lists[@]}" </dev/null >"$1/unity.list"
    stanza_entries "$suites" "${stanzas[@]}" </dev/null >"$1/unity.sources"
    [[ -s $1/unity.list || -s $1/unity.sources ]]
}

# private_apt DIR ARGUMENTS...: apt-get with lists, cache and entries under DIR.
private_apt() {
    local dir=$1 user=_apt
    shift
    if ((EUID == 0)); then
        user=root
    fi
    apt-get -o Dir::Etc::SourceList=/dev/null -o Dir::Etc::SourceParts="$dir/entries" \
        -o Dir::State::Lists="$dir/lists" -o Dir::Cache="$dir/cache" \
        -o APT::Sandbox::User="$user" -o Acquire::Languages=none "$@"
}

unity_download() {
    mkdir -p "$1/lists/partial" "$1/cache/archives/partial"
    private_apt "$1" update || echo "some lists failed; going on with the others"
    (cd "$1" && private_apt "$1" source --download-only --tar-only "$unity_package")
}

# Checks the pin, then puts the flat folder of Unity's files in place in one rename.
unity_unpack() {
    local dir=$1 new=$1/unity found
    found=$(cd "$dir" && echo *.orig.tar.*)
    if [[ ! -f $dir/$unity_tarball ]]; then
        echo "expected $unity_tarball of Debian 12, found: $found"
        return 1
    fi
    if ! echo "$unity_sha256  $dir/$unity_tarball" | sha256sum --check --status; then
        echo "$unity_tarball has the wrong sha256 $(sha256sum <"$dir/$unity_tarball")"
        echo "allowed is $unity_sha256 only: the mirror or the download is not to be trusted"
        return 1
    fi
    mkdir -p "$new"
    tar --no-same-owner -xJf "$dir/$unity_tarball" -C "$new" --strip-components=3 \
        --wildcards '*/tests/unity/unity*.[ch]' && [[ -s $new/unity.c ]] &&
        rm -rf "$2" && mv "$new" "$2"
}

# need_unity: leaves Unity in .deps/unity unless UNITY_SOURCE_DIR names another copy.
need_unity() {
    local apt=$exk_root/.deps/apt place=$exk_root/.deps/unity
    local way_out="or set UNITY_SOURCE_DIR to a folder that holds unity.c and unity.h (version 2.5 or later)"
    if [[ -n ${UNITY_SOURCE_DIR:-} ]]; then
        [[ -s $UNITY_SOURCE_DIR/unity.c ]] ||
            die 2 "UNITY_SOURCE_DIR=$UNITY_SOURCE_DIR holds no unity.c; unset it to have it fetched"
        return
    fi
    if [[ -s $place/unity.c ]]; then
        return
    fi
    rm -rf "$apt"
    unity_entries "$apt/entries" ||
        die 2 "no entry for Debian's own suite among apt's sources: add one, $way_out"
    note "$exk_me: Unity comes from the Debian source package $unity_package into .deps/unity"
    step "Unity, download" unity_download "$apt" ||
        die 3 "Unity could not be fetched: see that the network is there and try again, $way_out"
    step "Unity, check and unpack" unity_unpack "$apt" "$place" ||
        die 3 "Unity was fetched but is not the pinned one: use Debian 12's mirror, $way_out"
    rm -rf "$apt"
}
