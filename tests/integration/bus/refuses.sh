# What exk-log refuses, to the letter.
. "$(dirname "$0")/common.sh"
short p.ini
expect_code 0 "$bin/exk-loop" p.ini --fast -r run.lcm

# an output that exists and is not ours
echo "my thesis" >thesis.txt
expect_code 2 "$bin/exk-log" thesis.txt --url="$url" --seconds 0.1
expect_text err "exk-log: thesis.txt exists and is not an LCM log: not overwritten; choose another name or move it away"
expect_text thesis.txt "my thesis"
expect_code 2 "$bin/exk-log" --from run.lcm --csv thesis.txt
expect_text err "exk-log: thesis.txt: exists and is not an earlier result of this kind, so it is left as it is: choose another name or remove it"
expect_text thesis.txt "my thesis"
expect_code 2 "$bin/exk-loop" p.ini --fast -r thesis.txt
expect_text err "exk-loop: thesis.txt exists and is not an LCM log: not overwritten; choose another name or move it away"
expect_text thesis.txt "my thesis"

# a log cut in the middle: all whole samples, said, exit 1
bytes=$(stat -c %s run.lcm)
head -c $((bytes / 2 + 7)) run.lcm >cut.lcm
expect_code 1 "$bin/exk-log" --from cut.lcm --csv cut.csv
expect_text err "exk-log: cut.lcm ends inside a record: all whole ones before it are used"
expect_code 0 "$bin/exk-log" --from run.lcm --csv whole.csv
n=$(wc -l <cut.csv)
[ "$n" -gt 100 ] || fail "the cut log gave $n lines"
head -n "$n" whole.csv | cmp - cut.csv || fail "the cut log's samples are not the first of the whole one"

# what is no log of ours
expect_code 2 "$bin/exk-log" --from thesis.txt
expect_text err "exk-log: thesis.txt: not an LCM log: record with exk-log, exk-loop --record or lcm-logger"
: >empty.lcm
expect_code 2 "$bin/exk-log" --from empty.lcm
expect_text err "exk-log: empty.lcm: empty: no message was recorded"
expect_code 3 "$bin/exk-log" --from missing.lcm
expect_text err "exk-log: missing.lcm: cannot be opened: No such file or directory"
printf '\355\241\332\001\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\6\0\0\0\2CAMERAhi' >camera.lcm
expect_code 2 "$bin/exk-log" --from camera.lcm
expect_text err "exk-log: camera.lcm: an LCM log, but without EXK_POSE (1 message of other channels); record one with exk-log or exk-loop --record"
printf '\355\241\332\001\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\10\0\0\0\2EXK_POSEhi' >types.lcm
expect_code 2 "$bin/exk-log" --from types.lcm
expect_text err "exk-log: types.lcm: no pose of ours: 1 message on our channels is of other types; was it written by another version of exk?"

# wrong use
expect_code 2 "$bin/exk-log"
expect_text err "exk-log: the LOG to write is missing, for example run.lcm; or --from FILE"
expect_code 2 "$bin/exk-log" --from run.lcm also.lcm
expect_text err "exk-log: --from reads a log, nothing is recorded: also.lcm has no place beside it"
expect_code 2 "$bin/exk-log" run.lcm --seconds nan
expect_text err "exk-log: --seconds nan: a number of seconds above 0 is allowed"
expect_code 2 "$bin/exk-log" run.lcm --plot path.pdf
expect_text err "exk-log: --plot path.pdf: a picture ends in .svg or .png"
# a URL that cannot be one of LCM's is wrong use in every program; one that nobody answers is not
expect_code 0 "$bin/exk-command" keygen op.key
with_url() {
    expect_code "$1" "$bin/exk-log" new.lcm --seconds 0.1 --url="$2"
    expect_part err "$3"
    expect_code "$1" "$bin/exk-loop" p.ini --url="$2"
    expect_part err "$3"
    expect_code "$1" "$bin/exk-loop" p.ini --fast --source bus --url="$2"
    expect_part err "$3"
    expect_code "$1" "$bin/exk-twin" p.ini --url="$2"
    expect_part err "$3"
    expect_code "$1" "$bin/exk-command" stop --key op.key --url="$2"
    expect_part err "$3"
    expect_code "$1" "$bin/exk-holes" --live --seconds 0.1 --url="$2"
    expect_part err "$3"
}
for bad in nonsense:// udpm://239.255.76.67 "udpm://239.255.76.67:7667?ttl=x" ""; do
    with_url 2 "$bad" "LCM URL \"$bad\": "
    expect_code 2 "$bin/exk-doctor" --url="$bad"
    expect_part err "LCM URL \"$bad\": "
done
with_url 3 tcpq://127.0.0.1:1 "tcpq://127.0.0.1:1: LCM cannot open this URL: no lcm-tcpq-server answers there"
expect_code 1 "$bin/exk-doctor" --url=tcpq://127.0.0.1:1
expect_code 3 "$bin/exk-log" no/such/folder.lcm --url="$url" --seconds 0.1
expect_text err "exk-log: no/such/folder.lcm.part: cannot be created: No such file or directory"
exit 0
