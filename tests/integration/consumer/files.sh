#!/usr/bin/env bash
# What cmake --install must leave: files.sh BUILD_DIR SOURCE_DIR LIBDIR PROGRAM...
set -euo pipefail
build=$1 source=$2 libdir=$3
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cmake --install "$build" --prefix "$work" >/dev/null

shopt -s nullglob
missing=0
want() {
    if [[ ! -s $work/$1 ]]; then
        echo "not installed: $1"
        missing=1
    fi
}

for name in "${@:4}"; do
    want "bin/$name"
    if [[ -d $build/man ]]; then
        want "share/man/man1/$name.1"
    fi
done
for header in "$source"/include/exk/*.h; do
    want "include/exk/$(basename "$header")"
done
for profile in "$source"/profiles/*; do
    want "share/exk/profiles/$(basename "$profile")"
done
want include/exk/version.h
want "$libdir/libexk_loop.a"
want "$libdir/pkgconfig/exk.pc"
want "$libdir/cmake/exk/exkConfig.cmake"
if grep -rlF "$source" "$work/$libdir/cmake" "$work/$libdir/pkgconfig"; then
    echo "these installed files name the source folder"
    missing=1
fi
exit "$missing"
