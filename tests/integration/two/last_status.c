/* last_status LOG: the counts of the log's last EXK_STATUS, a name and a number a line. */
#include <inttypes.h>
#include <stdio.h>

#include "exk/event_file.h"
#include "exk/wire.h"

static void print(const exk_wire_status *s)
{
    const exk_link_counts *link = &s->bus.link;
    const exk_command_counts *command = &s->bus.command;
    printf("run_id %" PRId64 "\nstate %s\nfault %" PRId32 "\nsteps %" PRId64 "\nbad %" PRId64
           "\n",
           s->stamp.run_id, exk_state_name(s->state), s->fault, s->n_steps, s->n_bad);
    printf("lost %" PRId64 "\nlate %" PRId64 "\nrepeated %" PRId64 "\nreordered %" PRId64
           "\nforeign %" PRId64 "\ntaken %" PRId64 "\n",
           link->n_lost, link->n_late, link->n_repeated, link->n_reordered, link->n_foreign,
           command->n_taken);
    static const char *const kinds[EXK_REFUSED_COUNT] = {
        "malformed", "other_run", "wrong_key", "stale", "replayed", "unknown", "full"};
    for (int i = 0; i < EXK_REFUSED_COUNT; i++) {
        printf("%s %" PRId64 "\n", kinds[i], command->n_refused[i]);
    }
    printf("dropped %" PRId64 "\nreason %s\n", s->n_dropped, s->reason);
}

int main(int argc, char **argv)
{
    exk_event_reader reader;
    exk_wire_status status;
    exk_wire_status last;
    char why[512];
    bool found = false;
    if (argc != 2 || !exk_event_reader_open(&reader, argv[1], why, sizeof why)) {
        fprintf(stderr, "last_status: %s\n", argc == 2 ? why : "one LOG is wanted");
        return 2;
    }
    while (exk_event_reader_next(&reader) == EXK_EVENT_OK) {
        if (exk_wire_status_decode(reader.data, reader.bytes, &status)) {
            last = status;
            found = true;
        }
    }
    exk_event_reader_close(&reader);
    if (found) {
        print(&last);
    }
    return found ? 0 : 1;
}
