#!/usr/bin/env bash
# The page in headless Chromium, wide and narrow, light and dark: every drawing is there and has a
# size, no label lies on another or outside its drawing, nothing is wider than the screen.
source "$(dirname "$0")/common.sh"
here=$(cd "$(dirname "$0")" && pwd)
browser=$(command -v chromium || command -v chromium-browser || command -v google-chrome) || {
    echo "skipped: no Chromium here"
    exit 77
}

options=(--headless --no-sandbox --hide-scrollbars --disable-gpu --disable-quic --no-first-run
    --disable-background-networking --disable-component-update --disable-sync
    --window-size=1400,1000 --virtual-time-budget=20000)

# look PAGE WIDTH THEME: what measure.html says of it.
look() {
    local scheme=1
    [[ $3 == dark ]] && scheme=0
    rm -rf browser
    cat >frame.html <<END
<!DOCTYPE html>
<iframe src="$1" style="width:$2px;height:900px;border:0"></iframe>
<pre id="measured"></pre>
<script>
onmessage = (e) => { document.getElementById("measured").textContent = e.data; };
</script>
END
    timeout 60 "$browser" "${options[@]}" --user-data-dir="$work/browser" \
        --blink-settings="preferredColorScheme=$scheme" --dump-dom "file://$work/frame.html" \
        2>log |
        awk '/<pre id="measured">/ {on = 1; sub(/.*<pre id="measured">/, "")}
            on {line = $0; sub(/<\/pre>.*/, "", line); print line}
            /<\/pre>/ {on = 0}' >said
    grep -q '^measured' said || fail "Chromium did not draw $1: $(tail -n 3 log)"
}

measurable() {
    sed "/<\/body>/{
        r $here/measure.html
        d
    }" "$1" >"$2"
}

make_page
measurable page.html measured.html
for width in 1280 390; do
    for theme in light dark; do
        look measured.html "$width" "$theme"
        want="measured $n_drawings drawings, 0 empty, 0 cut, 0 overlapping, page 0 px too wide,"
        want+=" contrast good, $theme, $width px"
        [[ $(cat said) == "$want" ]] || fail "wanted '$want', found: $(cat said)"
    done
done

# The measure finds what it is there for.
sed -e 's/<figure id="fig-sine">/<figure id="fig-sine" hidden>/' \
    -e 's/--muted:#515b66/--muted:#e0e0e0/' -e '0,/translate(/s//translate(-999,0) translate(/' \
    -e 's/class="lede"/style="width:2000px;max-width:none"/' page.html >bad.html
measurable bad.html measured.html
look measured.html 1280 light
for sign in "^empty fig-sine" "^cut fig-overview" "4 empty, [1-9]" "page [1-9]" "contrast 1"; do
    grep -q "$sign" said || fail "'$sign' is not seen: $(cat said)"
done
