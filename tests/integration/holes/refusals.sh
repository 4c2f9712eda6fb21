# Wrong use and wrong input, each with its words and exit code; nothing is written.
. "$(dirname "$0")/common.sh"
run_log good "${quiet_machine[@]}"

expect_code 2 "$holes"
expect_text err "exk-holes: a LOG is missing, for example run.lcm; or --live"
expect_code 2 "$holes" good.lcm other.lcm
expect_text err "exk-holes: one LOG is allowed, found a second: other.lcm (a file for JSON is given as --json=FILE)"
expect_code 2 "$holes" good.lcm --live
expect_text err "exk-holes: --live listens on the bus: the log good.lcm has no place beside it"
expect_code 2 "$holes" good.lcm --seconds 3
expect_text err "exk-holes: --url and --seconds go with --live"
for bad in 0 -1 nan inf 0.03mm ""; do
    expect_code 2 "$holes" good.lcm --tolerance "$bad"
    expect_text err "exk-holes: --tolerance $bad: a number of millimetres above 0 is allowed"
done
expect_code 2 "$holes" --live --seconds soon
expect_text err "exk-holes: --seconds soon: a number of seconds above 0 is allowed"
expect_code 2 "$holes" good.lcm --plot holes.gif
expect_text err "exk-holes: --plot holes.gif: a picture ends in .svg or .png"
expect_code 2 "$holes" good.lcm --json --csv -
expect_text err "exk-holes: --json and --csv - both want standard output: give one a file, --json=FILE or --csv FILE"

expect_code 3 "$holes" nowhere.lcm
expect_text err "exk-holes: nowhere.lcm: cannot be opened: No such file or directory"
echo "id,x_mm,y_mm" >table.lcm
expect_code 2 "$holes" table.lcm
expect_text err "exk-holes: table.lcm: not an LCM log: record with exk-log, exk-loop --record or lcm-logger"
: >empty.lcm
expect_code 2 "$holes" empty.lcm
expect_text err "exk-holes: empty.lcm: empty: no message was recorded"
edit good.lcm renamed.lcm rename
expect_code 2 "$holes" renamed.lcm
n=$(LC_ALL=C grep -aobF "$(printf '\xed\xa1\xda\x01')" good.lcm | wc -l) # sync words: one a message
expect_text err "exk-holes: renamed.lcm: an LCM log, but without EXK_POSE ($n messages of other channels); record one with exk-log or exk-loop --record"
edit good.lcm foreign.lcm foreign
expect_code 2 "$holes" foreign.lcm
n=$("$holes" good.lcm --json | sed -n 's/^  "n_samples": \([0-9]*\),$/\1/p')
expect_text err "exk-holes: foreign.lcm: no pose of ours: $n messages on our channels are of other types; was it written by another version of exk?"
edit good.lcm jobless.lcm without=EXK_JOB
expect_code 2 "$holes" jobless.lcm
expect_text err "exk-holes: jobless.lcm: no EXK_JOB message, so the targets are not known: record for more than a second, the job is sent every second"
exit 0
