#!/usr/bin/env bash
# A machine's apt entries become entries for source packages: entries.sh SOURCE_DIR
set -euo pipefail
source "$1/cmake/unity.sh"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

compare() {
    diff -u --label "$1, wanted" --label "$1, found" "$work/want" "$work/found"
}

cat >"$work/one.list" <<'END'
# deb http://commented.test/debian bookworm main
deb http://mirror.test/debian bookworm main contrib # trailing words
deb [signed-by=/etc/key.gpg arch=amd64] http://mirror.test/debian/ stable main
deb-src http://mirror.test/debian bookworm main
deb http://mirror.test/debian bookworm-updates main
deb http://other.test/tool bookworm tool
deb http://other.test/tool tool-bookworm main
deb cdrom:[Debian 12]/ bookworm main
END
cat >"$work/want" <<'END'
deb-src http://mirror.test/debian bookworm main
deb-src [signed-by=/etc/key.gpg arch=amd64] http://mirror.test/debian/ stable main
END
list_entries "bookworm stable" "$work/one.list" >"$work/found"
compare "one-line entries"

cat >"$work/one.sources" <<'END'
Types: deb deb-src
# a remark
URIs: http://mirror.test/debian
Suites: bookworm bookworm-updates
Components: main non-free-firmware
Signed-By:
 -----BEGIN PGP PUBLIC KEY BLOCK-----
 .
 abc

Types: deb
URIs: http://off.test/debian
Suites: bookworm
Components: main
Enabled: no

Types: deb
URIs: http://other.test/tool
Suites: nodistro
Components: main
END
cat >"$work/two.sources" <<'END'
types: deb
URIs: http://first.test/debian
 http://second.test/debian
suites: stable
components: main
END
cat >"$work/want" <<'END'
Types: deb-src
URIs: http://mirror.test/debian
Suites: bookworm
Components: main
Signed-By:
 -----BEGIN PGP PUBLIC KEY BLOCK-----
 .
 abc

Types: deb-src
URIs: http://first.test/debian http://second.test/debian
Suites: stable
Components: main

END
stanza_entries "bookworm stable" "$work/one.sources" "$work/two.sources" >"$work/found"
sed -i 's/^URIs:  */URIs: /' "$work/found"
compare "deb822 entries"
