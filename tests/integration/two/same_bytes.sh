# In lock-step the log of two processes is that of one, to the byte: with sensor noise, a servo lag, fresh
# noise, another series and run, against one twin process, and however the source is told.
. "$(dirname "$0")/common.sh"
short p.ini -e 's/^repeat *=.*/repeat = fresh/' -e 's/^\[loop\]/[sensor]\nsigma_rad = 1e-5\n[loop]/'
sed -e 's/^\[loop\]/[loop]\nsource = bus/' p.ini >bus.ini
machine p.ini --url="$url"
for options in "" "--series 3 --run 2"; do
    expect_code 0 "$bin/exk-loop" p.ini --fast $options -r one.lcm
    expect_code 0 "$bin/exk-loop" p.ini --fast $options -r two.lcm --source bus --url="$url"
    cmp one.lcm two.lcm || fail "two processes write another log than one ($options)"
    expect_code 0 "$bin/exk-loop" bus.ini --fast $options -r one.lcm --source twin
    expect_code 0 "$bin/exk-loop" bus.ini --fast $options -r two.lcm --url="$url"
    cmp one.lcm two.lcm || fail "source = bus writes another log than --source twin ($options)"
done
grep -q "run .* ended: [0-9]* ticks answered; of its commands 0 were lost, 0 repeated, 0 out of order; 0" exk-twin.err ||
    { cat exk-twin.err >&2; fail "the twin does not say how a run went"; }
# with faults put into the sensor: the twin's own, and the loop's guard sees the same
for kind in nan spike dropout delay stuck garbage; do
    sed -e "s/^\[loop\]/[fault.1]\nkind = $kind\nat_s = 0.3\nfor_s = 0.015\n[loop]/" p.ini >faulty.ini
    start "$bin/exk-twin" faulty.ini --url="$url_behind" --once -q
    twin=$started
    sleep 0.2
    expect_code 0 "$bin/exk-loop" faulty.ini --fast -r one.lcm
    expect_code 0 "$bin/exk-loop" faulty.ini --fast -r two.lcm --source bus --url="$url_behind"
    cmp one.lcm two.lcm || fail "$kind: two processes write another log than one"
    ends "$twin" 0
done

sed 's/^sigma_rad = 1e-5/sigma_rad = 2e-5/' p.ini >other.ini
expect_code 0 "$bin/exk-loop" other.ini --fast -r one.lcm
expect_code 0 "$bin/exk-loop" other.ini --fast -r two.lcm --source bus --url="$url"
cmp -s one.lcm two.lcm && fail "the noise is not the twin's own"
exit 0
