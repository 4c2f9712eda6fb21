# Bad input as a user brings it: each refused before anything starts, with the exact message.
. "$(dirname "$0")/common.sh"

# refused MESSAGE...: bad.ini ends with 2 and says exactly these lines; --fast starts no log for it
refused() {
    printf '%s\n' "$@" >want
    for how in "--check" "--fast -r never.lcm"; do
        # shellcheck disable=SC2086 # two words
        expect_code 2 "$bin/exk-loop" bad.ini $how
        cmp -s err want || { cat err >&2; fail "bad.ini $how did not say exactly: $*"; }
        [ -s out ] && fail "bad.ini $how printed a result"
    done
    [ -e never.lcm ] || [ -e never.lcm.part ] && fail "a log was started for: $*"
    return 0
}

# line_of KEY: where it stands in bad.ini
line_of() { grep -n "^$1 *=" bad.ini | cut -d: -f1; }

short bad.ini -e 's/^dwell_s/dwel_s/'
refused "bad.ini:$(line_of dwel_s): [job] dwel_s: unknown key; did you mean dwell_s?"
short bad.ini -e '/^\[job\]/,/^$/d'
refused "bad.ini: missing section [job]; add it with kind = rectangle, grid or csv"
short bad.ini -e 's/^\[kinematics\]/[machine]\nd3_mm = 500\nd4_mm = 375\n&/'
refused "bad.ini:$(line_of d3_mm): [machine] d3_mm: ratio p3 = 2 d3/d1 out of range: found 1.111, allowed: 0.5 to 1 (d3_mm = 500, d1_mm = 900); choose d3_mm 225 to 450"
short bad.ini
sed -i 's/^dwell_s *=.*/dwell_s = nan/' bad.ini
refused "bad.ini:$(line_of dwell_s): [job] dwell_s: NaN is no value: found \"nan\", allowed: 0 s or more"
short bad.ini -e 's/^rate_Hz *=.*/rate_Hz = -1000/'
refused "bad.ini:$(line_of rate_Hz): [loop] rate_Hz: out of range: found \"-1000\", allowed: 1 to 40000 Hz"
short bad.ini -e 's/^rate_Hz *=.*/rate_Hz = 0/' -e 's/^seed *=.*/sed = 1/'
refused "bad.ini:$(line_of rate_Hz): [loop] rate_Hz: out of range: found \"0\", allowed: 1 to 40000 Hz" \
    "bad.ini:$(line_of sed): [loop] sed: unknown key; did you mean seed?"

# csv_job MODEL LINES: bad.ini drills the holes of holes.csv, there and not back
csv_job() {
    short bad.ini -e 's/^kind *=.*/kind = csv\nfile = holes.csv/' -e '/^width_mm\|^height_mm/d' \
        -e 's/^closed *=.*/closed = no/' -e "s/^model *=.*/model = $1/"
    printf "%b" "$2" >holes.csv
}
csv_job machine 'id,x_mm,y_mm\n1,0,0\n17,900,0\n'
refused "bad.ini: hole 17: the machine cannot travel to it at x 637.500 y 0.000 z 1450.000 mm: leg 1 would be 1350.055 mm long, limit 1350.000 mm; move the hole or change [machine]"
csv_job pendulum 'id,x_mm,y_mm\n17,900,0\n'
refused "bad.ini: hole 17: the machine cannot work on it at x 900.000 y 0.000 z 950.000 mm: alpha or beta would be beyond 34.4 deg; move the hole or change [machine]"
csv_job pendulum 'id,x_mm,y_mm\n1,0,0\n2,5,5\n1,9,9\n'
refused "holes.csv:4: id: given twice: found 1, first in line 2; give each hole its own"
csv_job pendulum ''
refused "holes.csv: empty: no header and no hole; the first line names the columns: id,x_mm,y_mm"
csv_job pendulum 'id,x_mm,y_mm\n'
refused "holes.csv: no hole: the header stands alone; add a line a hole"
csv_job pendulum 'id,x_mm,y_mm\n1,nan,0\n'
refused 'holes.csv:2: x_mm: not finite: found "nan", allowed: any finite number'
csv_job pendulum ''
rm holes.csv
expect_code 3 "$bin/exk-loop" bad.ini --check
expect_text err "holes.csv: cannot be opened: No such file or directory"
exit 0
