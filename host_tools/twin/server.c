#include "server.h"

#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const int64_t silence_us = 1000000;

static void answer(twin_server *s, const exk_wire_drive *drive)
{
    unsigned char buffer[EXK_WIRE_SENSOR_MAX];
    s->answer.stamp.run_id = s->run_id;
    s->answer.stamp.seq = s->seq++;
    s->answer.stamp.k = drive->stamp.k;
    s->answer.stamp.time_us = drive->stamp.time_us;
    s->answer.drive_seq = drive->stamp.seq;
    s->answer.session_id = s->session_id;
    s->answer.machine_id = s->machine_id;
    const int bytes = exk_wire_sensor_encode(&s->answer, buffer, sizeof buffer);
    if (bytes > 0) {
        exk_bus_send(s->bus, EXK_CHANNEL_SENSOR, buffer, (size_t)bytes);
    }
}

static void end_run(twin_server *s, const char *how)
{
    s->busy = false;
    s->over = true;
    if (!s->quiet) {
        fprintf(stderr,
                "exk-twin: run %" PRId64 " %s: %" PRId64
                " ticks answered; of its commands %" PRId64 " were lost, %" PRId64
                " repeated, %" PRId64 " out of order; %" PRId64 " messages were none of its\n",
                s->run_id, how, s->n_ticks, s->arrivals.n_lost, s->arrivals.n_repeated,
                s->arrivals.n_reordered, s->n_not_ours);
    }
}

static void refuse(twin_server *s, const exk_wire_drive *drive)
{
    s->n_not_ours++;
    if (!s->quiet && s->refused_session != drive->session_id) {
        fprintf(stderr,
                "exk-twin: run %" PRId64 " has to wait: run %" PRId64 " drives this machine\n",
                drive->stamp.run_id, s->run_id);
    }
    s->refused_session = drive->session_id;
}

static void begin_run(twin_server *s, const exk_wire_drive *hello)
{
    const exk_err err = exk_rig_start_machine(s->rig, hello->which, &s->machine);
    if (err != EXK_OK) {
        fprintf(stderr, "exk-twin: the machine cannot be set up: %s\n", exk_err_name(err));
        return;
    }
    s->busy = true;
    s->over = false;
    s->run_id = hello->stamp.run_id;
    s->session_id = hello->session_id;
    s->seq = 0;
    s->n_ticks = 0;
    s->n_not_ours = 0;
    s->answer = (exk_wire_sensor){.stamp.k = -1};
    exk_arrivals_init(&s->arrivals);
    s->arrivals.newest = hello->stamp.seq - 1; /* the hellos before had nobody to hear them */
    s->other_rate = false;
    if (!s->quiet) {
        fprintf(stderr,
                "exk-twin: run %" PRId64 " begins, series %" PRIu32 " run %" PRIu32 "\n",
                s->run_id, hello->which.series, hello->which.run);
    }
}

static void step(twin_server *s, const exk_wire_drive *drive)
{
    const int64_t k = drive->stamp.k;
    if (k < s->answer.stamp.k) {
        s->n_not_ours++; /* the machine is past it */
        return;
    }
    if (k > s->answer.stamp.k) {
        exk_reading reading = {.fresh = false};
        if (s->machine.exchange(s->machine.ctx, k, &drive->drive, &reading) != EXK_OK) {
            reading.fresh = false;
        }
        s->answer.reading = reading;
        s->n_ticks++;
    }
    answer(s, drive);
}

/* k dt of the drive is k dt here: a servo lag and a random walk of another rate are another machine. */
static bool has_our_rate(twin_server *s, const exk_wire_drive *drive)
{
    const double dt_s = s->rig->profile.timing.dt_s;
    const int64_t want_us = llround((double)drive->stamp.k * dt_s * 1e6);
    if (llabs(drive->stamp.time_us - want_us) <= 1) {
        return true;
    }
    if (!s->other_rate) {
        s->other_rate = true;
        fprintf(stderr,
                "exk-twin: run %" PRId64 " is at %" PRId64 " us in tick %" PRId64
                ", this machine's profile has ticks of %g us: it gets no answer; start "
                "exk-twin with the profile of the controller\n",
                s->run_id, drive->stamp.time_us, drive->stamp.k, 1e6 * dt_s);
    }
    return false;
}

static bool is_ours(const twin_server *s, const exk_wire_drive *drive)
{
    return drive->stamp.run_id == s->run_id && drive->session_id == s->session_id;
}

static void obey(twin_server *s, const exk_wire_drive *drive)
{
    exk_arrivals_take(&s->arrivals, drive->stamp.seq);
    if (drive->kind == EXK_DRIVE_BYE) {
        end_run(s, "ended");
    } else if (drive->kind == EXK_DRIVE_STEP && has_our_rate(s, drive)) {
        step(s, drive);
    } else if (drive->kind == EXK_DRIVE_HELLO && s->n_ticks == 0) {
        answer(s, drive);
    }
}

void twin_server_receive(void *ctx, const char *channel, const void *data, size_t bytes,
                         int64_t received_us)
{
    twin_server *s = ctx;
    exk_wire_drive drive;
    (void)channel;
    if (!exk_wire_drive_decode(data, bytes, &drive)) {
        s->n_not_ours++;
        return;
    }
    const bool ours = s->busy && is_ours(s, &drive);
    if (!ours && s->busy && received_us - s->heard_us < silence_us) {
        refuse(s, &drive);
        return;
    }
    if (!ours && s->busy) {
        end_run(s, "fell silent");
    }
    if (!ours && drive.kind == EXK_DRIVE_HELLO) {
        begin_run(s, &drive);
    }
    if (s->busy && is_ours(s, &drive)) {
        s->heard_us = received_us;
        obey(s, &drive);
    }
}
