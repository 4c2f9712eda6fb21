#!/usr/bin/env bash
# calibrate --write: values that give the published means, comments and all other lines kept; a second
# time nothing changes.
source "$(dirname "$0")/common.sh"
cp -r "$profiles/study" mine
sed -i 's/^sigma_rad_per_sqrt_s = .*/sigma_rad_per_sqrt_s = 5e-5/' mine/s[568]_*.ini
sed -i 's/^ki_per_s = .*/ki_per_s = 3/' mine/s6_pi.ini
"$study" calibrate --seeds 10 --profiles mine --write >first
# Each value has four digits, so its mean may be off by 1 in 2000 at most.
awk '/published/ {n++; for (i = 1; i < NF; i++) if ($(i + 1) == "mm,") ours = $i
     if (ours / $(NF - 1) - 1 > 1e-3 || 1 - ours / $(NF - 1) > 1e-3) exit 1}
     END {if (n != 3) exit 1}' first || fail "means: $(cat first)"
for file in "$profiles"/study/*.ini; do
    name=$(basename "$file")
    diff <(grep -v '^sigma_rad\|^ki_per_s' "$file") <(grep -v '^sigma_rad\|^ki_per_s' "mine/$name") ||
        fail "$name: other lines changed"
done
cp -r mine before
"$study" calibrate --seeds 10 --profiles mine --write >second
for file in mine/*.ini; do
    diff "$file" "before/$(basename "$file")" || fail "$file: a second calibration moved it"
done
