/** exk-command: one command to the controller on the bus. See options.c for its use. */
#include <inttypes.h>
#include <stdio.h>

#include "bus_url.h"
#include "exk/bus.h"
#include "exk/realtime.h"
#include "exk/standard_streams.h"
#include "exk/stop_signal.h"
#include "options.h"

enum { EXIT_REFUSED = 1, EXIT_INPUT = 2, EXIT_IO = 3, WHY_MAX = 1024 };
static const int64_t hear_us = 2000000;  /* a controller says its status at least this often */
static const int64_t reply_us = 1500000; /* its counts show what became of a command */
static const int64_t effect_us = 500000; /* a few statuses */

typedef struct {
    exk_bus *bus;
    exk_key_secret key;
    exk_wire_status status; /* the newest */
    bool has_status;
    int64_t last_seq;
} sender;

static int complain(int code, const char *why)
{
    fprintf(stderr, "exk-command: %s\n", why);
    return code;
}

static void hear(void *ctx, const char *channel, const void *data, size_t bytes,
                 int64_t received_us)
{
    sender *s = ctx;
    exk_wire_status status;
    (void)channel;
    (void)received_us;
    if (exk_wire_status_decode(data, bytes, &status) && !status.last) {
        s->status = status;
        s->has_status = true;
    } else if (s->has_status && status.stamp.run_id == s->status.stamp.run_id) {
        s->status = status;
    }
}

/* seq is the wall clock, so that one sender's next call is above its last one without a file. */
static bool send_command(sender *s, exk_command command)
{
    unsigned char buffer[EXK_WIRE_COMMAND_MAX];
    const int64_t now_us = exk_wall_us();
    s->last_seq = now_us > s->last_seq ? now_us : s->last_seq + 1;
    exk_wire_command m = {.run_id = s->status.stamp.run_id,
                          .seq = s->last_seq,
                          .utime_us = now_us,
                          .command = (int8_t)command};
    exk_command_sign(&m, &s->key);
    const int bytes = exk_wire_command_encode(&m, buffer, sizeof buffer);
    return bytes > 0 && exk_bus_send(s->bus, EXK_CHANNEL_COMMAND, buffer, (size_t)bytes);
}

static bool wait_for_controller(sender *s)
{
    const int64_t until_us = exk_wall_us() + hear_us;
    while (!s->has_status && exk_stop_signal() == 0 && exk_wall_us() < until_us) {
        if (exk_bus_wait(s->bus, 100) < 0) {
            return false;
        }
    }
    return s->has_status;
}

/* What was refused since, of the kinds that a command of ours can meet; others may have sent it. */
static bool say_refusals(const exk_command_counts *before, const exk_command_counts *after)
{
    bool any = false;
    for (int i = EXK_REFUSED_RUN; i < EXK_REFUSED_COUNT; i++) {
        if (after->n_refused[i] > before->n_refused[i]) {
            fprintf(stderr, "exk-command: refused: %s\n", exk_refusal_name((exk_refusal)i));
            any = true;
        }
    }
    return any;
}

/* The controller answers with its counts and with the seq of the last command it took. */
static int wait_for_reply(sender *s, const exk_command_counts *before)
{
    const int64_t until_us = exk_wall_us() + reply_us;
    const exk_command_counts *now = &s->status.bus.command;
    while (exk_stop_signal() == 0 && exk_wall_us() < until_us) {
        if (now->last_seq >= s->last_seq) {
            return 0;
        }
        exk_bus_wait(s->bus, 50);
    }
    if (say_refusals(before, now)) {
        return EXIT_REFUSED;
    }
    return complain(EXIT_REFUSED, "no reply: does the profile of this run say allow = yes in "
                                  "[command], and is it a real-time run?");
}

/* Where a command leads, and from where it is no use. */
static const struct {
    exk_state to;
    const char *from;
} effects[EXK_COMMAND_COUNT] = {
    [EXK_COMMAND_START] = {EXK_STATE_RUN, "it begins in idle and goes on in hold"},
    [EXK_COMMAND_STOP] = {EXK_STATE_HOLD, "it holds a run"},
    [EXK_COMMAND_ABORT] = {EXK_STATE_FAULT, "the run is over"},
    [EXK_COMMAND_CLEAR] = {EXK_STATE_IDLE, "it ends a fault, once nothing moves any more"},
};

static bool had_effect(const sender *s, exk_command command)
{
    const exk_state state = (exk_state)s->status.state;
    return command == EXK_COMMAND_ALIVE || state == effects[command].to ||
           (command == EXK_COMMAND_START && state == EXK_STATE_DONE);
}

/* The gate took the command; the state it leads to is in this status, or in the next. */
static int wait_for_effect(sender *s, exk_command command)
{
    const int64_t until_us = exk_wall_us() + effect_us;
    while (!had_effect(s, command) && exk_stop_signal() == 0 && exk_wall_us() < until_us) {
        exk_bus_wait(s->bus, 50);
    }
    if (had_effect(s, command)) {
        return 0;
    }
    fprintf(stderr, "exk-command: %s: no effect in state %s: %s\n", exk_command_name(command),
            exk_state_name((exk_state)s->status.state), effects[command].from);
    return EXIT_REFUSED;
}

static int keep_on(const command_options *options, sender *s)
{
    int64_t next_us = exk_wall_us();
    while (exk_stop_signal() == 0 && !s->status.last) {
        if (exk_wall_us() >= next_us) {
            next_us = exk_wall_us() + (int64_t)(options->keep_s * 1e6);
            if (!send_command(s, EXK_COMMAND_ALIVE)) {
                return complain(EXIT_IO, "the bus refuses messages: exk-doctor finds out why");
            }
        }
        exk_bus_wait(s->bus, (int)(options->keep_s * 500.0) + 1);
    }
    if (!options->quiet && exk_stop_signal() != 0) {
        fprintf(stderr, "exk-command: no more alive from here: the controller holds when its "
                        "timeout_s has passed\n");
    }
    return 0;
}

static int converse(const command_options *options, sender *s)
{
    if (!wait_for_controller(s)) {
        return complain(EXIT_IO,
                        "no controller is heard: is exk-loop running, and on this URL?");
    }
    const exk_command_counts before = s->status.bus.command;
    if (!send_command(s, options->command)) {
        return complain(EXIT_IO, "the bus refuses messages: exk-doctor finds out why");
    }
    int code = wait_for_reply(s, &before);
    if (code == 0) {
        code = wait_for_effect(s, options->command);
    }
    if (code != 0) {
        return code;
    }
    printf("%s: taken by run %" PRId64 ", state %s\n", exk_command_name(options->command),
           s->status.stamp.run_id, exk_state_name(s->status.state));
    fflush(stdout);
    return options->keep_s > 0.0 ? keep_on(options, s) : 0;
}

static int command(const command_options *options)
{
    static sender s;
    char why[WHY_MAX];
    char url[WHY_MAX];
    if (!exk_key_load(options->key_path, &s.key, why, sizeof why)) {
        return complain(EXIT_INPUT, why);
    }
    exk_bus_url(options->url, url, sizeof url);
    if (!exk_bus_url_good(url, why, sizeof why)) {
        return complain(EXIT_INPUT, why);
    }
    s.bus = exk_bus_open(url, true, why, sizeof why);
    if (s.bus == NULL ||
        !exk_bus_listen(s.bus, EXK_CHANNEL_STATUS, hear, &s, why, sizeof why)) {
        exk_bus_close(s.bus);
        return complain(EXIT_IO, why);
    }
    const int code = converse(options, &s);
    exk_bus_close(s.bus);
    exk_key_wipe(&s.key);
    return code;
}

int main(int argc, char **argv)
{
    command_options options;
    char why[WHY_MAX];
    exk_standard_streams_hold();
    command_options_parse(argc, argv, &options);
    exk_stop_catch();
    if (!options.keygen) {
        return command(&options);
    }
    if (!exk_key_make(options.key_path, why, sizeof why)) {
        return complain(EXIT_IO, why);
    }
    printf("%s: a new key, mode 0600; name it in key_file of [command] and with --key\n",
           options.key_path);
    return 0;
}
