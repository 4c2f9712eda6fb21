#!/usr/bin/env bash
# Wrong use and unsupported systems end with a clear message: refusals.sh SOURCE_DIR
set -uo pipefail
source_dir=$1
empty=$(mktemp -d)
trap 'rm -rf "$empty"' EXIT

# expect CODE WORDS COMMAND...
expect() {
    local said rc
    said=$("${@:3}" 2>&1 </dev/null)
    rc=$?
    if ((rc != $1)) || [[ $said != *"$2"* ]]; then
        printf 'wanted exit %s and "%s" from: %s\nfound exit %s and:\n%s\n' \
            "$1" "$2" "${*:3}" "$rc" "$said"
        exit 1
    fi
}

# A system with the usual tools but without apt.
for tool in bash env dirname cat; do
    ln -s "$(command -v "$tool")" "$empty/$tool"
done

for door in drill check; do
    expect 0 "Usage: ./$door" "$source_dir/$door" --help
    expect 2 "unknown" "$source_dir/$door" --no-such-option
    expect 2 "one " "$source_dir/$door" a b
done
expect 2 "no/such/profile.ini' not found" "$source_dir/drill" no/such/profile.ini
expect 2 "no apt-get: only Debian 12" env PATH="$empty" bash -c "
    exk_me=t; source '$source_dir/cmake/setup.sh'; need_packages liblcm-dev"
expect 2 "holds no unity.c" env UNITY_SOURCE_DIR="$empty" bash -c "
    exk_me=t; source '$source_dir/cmake/setup.sh'; source '$source_dir/cmake/unity.sh'; need_unity"
