# Commands as an operator gives them: start, stop, start, abort, clear; silence holds; nobody is obeyed
# without the key, or where the profile does not allow it.
. "$(dirname "$0")/common.sh"
expect_code 0 "$bin/exk-command" keygen op.key
[ "$(stat -c %a op.key)" = 600 ] || fail "the key is not private"
short p.ini -e 's/^\[loop\]/[command]\nallow = yes\nkey_file = op.key\nwait = yes\ntimeout_s = 0.6\n[loop]\nmissed_max = 100000/'
command="$bin/exk-command"

# says TEXT command...: exit 0 and this on stdout
says() { expect_code 0 "${@:2}" --url="$url" && expect_part out "$1"; }

start "$bin/exk-loop" p.ini --url="$url" -r run.lcm
loop=$started
sleep 0.5
expect_code 0 "$bin/exk-command" keygen other.key
expect_code 1 "$command" start --key other.key --url="$url"
expect_part err "refused: wrong key"
says "start: taken" "$command" start --key op.key
sleep 0.2
says "stop: taken" "$command" stop --key op.key
says "alive: taken by run" "$command" alive --key op.key
expect_part out "state hold"
start "$command" start --key op.key --url="$url" --keep
keeper=$started
ends "$loop" 0
ends "$keeper" 0
expect_part exk-loop.out "4 of 4 holes drilled"
expect_count run.lcm wrong_key -eq 1
expect_count run.lcm taken -ge 6
expect_count run.lcm replayed -eq 0

# silence: hold; abort: fault; clear: idle; the run waits all the while
start "$bin/exk-loop" p.ini --url="$url" -r run.lcm
loop=$started
sleep 0.5
says "start: taken" "$command" start --key op.key
sleep 0.9
says "state hold" "$command" alive --key op.key
says "abort: taken" "$command" abort --key op.key
says "state fault" "$command" alive --key op.key
expect_code 1 "$command" start --key op.key --url="$url"
expect_part err "start: no effect in state fault: it begins in idle and goes on in hold"
says "clear: taken" "$command" clear --key op.key
says "state idle" "$command" alive --key op.key
kill -INT "$loop"
ends "$loop" 1

rm -f run.fault*.lcm

# each fault of a run has its samples, written while the run goes on; they end with the fault
start "$bin/exk-loop" p.ini --url="$url" -r run.lcm
loop=$started
sleep 0.5
for file in run.fault.lcm run.fault2.lcm; do
    [ -e $file ] && fail "$file is there before its fault"
    says "start: taken" "$command" start --key op.key
    sleep 0.2
    says "abort: taken" "$command" abort --key op.key
    for _ in $(seq 40); do
        [ -e $file ] && break
        sleep 0.05
    done
    [ -e $file ] || fail "$file is not written while the run goes on"
    says "clear: taken" "$command" clear --key op.key
done
kill -INT "$loop"
ends "$loop" 1
for file in run.fault.lcm run.fault2.lcm; do
    expect_code 0 "$bin/exk-log" --from $file --csv fault.csv
    awk -F, 'NR > 2 && $2 <= k {exit 1} {k = $2} END {if (NR < 100) exit 1}' fault.csv ||
        fail "$file has no samples in order"
    sed -n '$p' fault.csv | cut -d, -f2 >last.$file
done
[ "$(cat last.run.fault.lcm)" -lt "$(sed -n 2p fault.csv | cut -d, -f2)" ] ||
    fail "the second capture has samples of the first"

# a profile that does not allow them looks at none
sed 's/^allow = yes/allow = no/; s/^wait = yes/wait = no/' p.ini >deaf.ini
start "$bin/exk-loop" deaf.ini --url="$url" -r run.lcm
loop=$started
sleep 0.5
expect_code 1 "$command" abort --key op.key --url="$url"
expect_part err "no reply: does the profile of this run say allow = yes"
ends "$loop" 0
expect_count run.lcm taken -eq 0

# keys that are refused before anything starts
chmod 640 op.key
expect_code 2 "$bin/exk-loop" p.ini --url="$url"
expect_part err "op.key: others may read or write this key (mode 0640): run chmod 600 on it"
expect_code 2 "$command" stop --key op.key --url="$url"
rm op.key
expect_code 2 "$bin/exk-loop" p.ini --url="$url"
expect_part err "op.key: cannot open the key: No such file or directory"
expect_code 3 "$command" stop --key other.key --url="$url"
expect_text err "exk-command: no controller is heard: is exk-loop running, and on this URL?"
ln -s other.key link.key
expect_code 2 "$command" stop --key link.key --url="$url"
expect_text err "exk-command: link.key: cannot open the key: a symbolic link is not followed: name the file itself"
expect_code 2 "$command" start --key other.key --keep=1e300
expect_text err "exk-command: --keep 1e300: at most 3600 seconds are allowed"
expect_code 2 "$command" jump --key other.key
expect_part err "jump: start, stop, abort, clear, alive or keygen is allowed"
exit 0
