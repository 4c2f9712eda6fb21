/** Makes of a good log one that a tool has to cope with: edit-log IN OUT [EDIT...]
 *
 *  lose=A-B      EXK_POSE with seq A to B left out
 *  until=K       nothing from the first EXK_POSE past tick K on
 *  without=CH    no message of channel CH
 *  rename        every channel under another name
 *  foreign       EXK_POSE carries eight bytes of another type
 */
#include <inttypes.h>
#include <stdbool.h>
#include <stdio.h>
#include <string.h>

#include "exk/event_file.h"
#include "exk/wire.h"

typedef struct {
    int64_t lose_from;
    int64_t lose_to;
    int64_t until;
    const char *without;
    bool rename;
    bool foreign;
} edits;

static bool read_edit(edits *e, const char *arg)
{
    if (sscanf(arg, "lose=%" SCNd64 "-%" SCNd64, &e->lose_from, &e->lose_to) == 2 ||
        sscanf(arg, "until=%" SCNd64, &e->until) == 1) {
        return true;
    }
    if (strncmp(arg, "without=", 8) == 0) {
        e->without = arg + 8;
        return true;
    }
    e->rename = e->rename || strcmp(arg, "rename") == 0;
    e->foreign = e->foreign || strcmp(arg, "foreign") == 0;
    return e->rename || e->foreign;
}

/* 0: keep, 1: leave out, 2: end here. */
static int verdict(const edits *e, const exk_event_reader *in)
{
    exk_wire_pose pose;
    if (e->without != NULL && strcmp(in->channel, e->without) == 0) {
        return 1;
    }
    if (strcmp(in->channel, EXK_CHANNEL_POSE) != 0 ||
        !exk_wire_pose_decode(in->data, in->bytes, &pose)) {
        return 0;
    }
    if (pose.sample.k > e->until) {
        return 2;
    }
    return pose.seq >= e->lose_from && pose.seq <= e->lose_to ? 1 : 0;
}

static bool copy(const edits *e, const exk_event_reader *in, exk_event_writer *out)
{
    static const unsigned char other[8] = {1, 2, 3, 4, 5, 6, 7, 8};
    char channel[80];
    const bool pose = strcmp(in->channel, EXK_CHANNEL_POSE) == 0;
    snprintf(channel, sizeof channel, "%s%s", e->rename ? "OTHER_" : "", in->channel);
    if (e->foreign && pose) {
        return exk_event_writer_add(out, in->stamp_us, channel, other, sizeof other);
    }
    return exk_event_writer_add(out, in->stamp_us, channel, in->data, in->bytes);
}

static bool edit(const edits *e, exk_event_reader *in, exk_event_writer *out)
{
    while (exk_event_reader_next(in) == EXK_EVENT_OK) {
        const int what = verdict(e, in);
        if (what == 2) {
            return true;
        }
        if (what == 0 && !copy(e, in, out)) {
            return false;
        }
    }
    return true;
}

int main(int argc, char **argv)
{
    edits e = {.lose_from = 0, .lose_to = -1, .until = INT64_MAX};
    exk_event_reader in;
    char why[512];
    for (int i = 3; i < argc; i++) {
        if (!read_edit(&e, argv[i])) {
            fprintf(stderr, "edit-log: what is %s?\n", argv[i]);
            return 2;
        }
    }
    if (argc < 3 || !exk_event_reader_open(&in, argv[1], why, sizeof why)) {
        fprintf(stderr, "edit-log: %s\n", argc < 3 ? "IN and OUT are missing" : why);
        return 2;
    }
    exk_event_writer *out = exk_event_writer_create(argv[2], why, sizeof why);
    bool good = out != NULL && edit(&e, &in, out);
    good = out != NULL && exk_event_writer_close(out, why, sizeof why) && good;
    exk_event_reader_close(&in);
    if (!good) {
        fprintf(stderr, "edit-log: %s\n", why);
    }
    return good ? 0 : 3;
}
