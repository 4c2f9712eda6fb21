#!/usr/bin/env bash
# A user's ten lines against the installed tree: run.sh cmake|pkg-config BUILD_DIR CC LIBDIR
# The tree is installed to a temporary prefix and moved once, so no path of the build may matter.
set -euo pipefail
way=$1 build=$2 cc=$3 libdir=$4
here=$(cd "$(dirname "$0")" && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

cmake --install "$build" --prefix "$work/first" >"$work/install.log"
mv "$work/first" "$work/prefix"

case $way in
cmake)
    cmake -S "$here" -B "$work/build" -DCMAKE_C_COMPILER="$cc" -DCMAKE_PREFIX_PATH="$work/prefix"
    cmake --build "$work/build"
    said=$("$work/build/consumer")
    ;;
pkg-config)
    command -v pkg-config >/dev/null || exit 77
    export PKG_CONFIG_PATH=$work/prefix/$libdir/pkgconfig
    # shellcheck disable=SC2046
    "$cc" -std=c11 "$here/main.c" -o "$work/consumer" $(pkg-config --cflags --libs exk)
    said=$("$work/consumer")
    ;;
*)
    echo "wanted cmake or pkg-config, found $way" >&2
    exit 2
    ;;
esac
echo "$said"
[[ $said == "exk "*": ok, x = 0.100000 m" ]]
