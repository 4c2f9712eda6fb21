#define _POSIX_C_SOURCE 200809L
#include "summary.h"

#include <inttypes.h>
#include <stdio.h>
#include <string.h>

#include "exk/command.h"
#include "exk/fault_text.h"
#include "exk/units.h"

static void print_accuracy(const loop_ending *ending)
{
    const exk_accuracy *accuracy = &ending->summary->accuracy;
    const exk_rig *rig = ending->rig;
    const double tolerance_mm = rig->profile.job.tolerance_m * EXK_MM_PER_M;
    printf("%s: %zu of %zu holes drilled, %zu inside %.3f mm", rig->profile.name,
           accuracy->n_drilled, rig->n_holes, accuracy->n_inside, tolerance_mm);
    if (accuracy->worst >= 0) {
        printf(", mean %.4f mm, worst hole %" PRId32 " with %.4f mm",
               accuracy->mean_m * EXK_MM_PER_M, rig->holes[accuracy->worst].id,
               accuracy->max_m * EXK_MM_PER_M);
    }
    printf(" (judged on the %s tip)\n", ending->record->sample.has_true ? "true" : "estimated");
}

static void print_counts(const loop_ending *ending)
{
    const exk_record *record = ending->record;
    printf("%" PRId64 " ticks of %.6g s, %" PRId64 " missed, %" PRId64 " bad samples, %" PRId64
           " poses published, %" PRId64 " dropped by the ring\n",
           record->sample.k + 1, ending->rig->plan.cfg.dt_s, ending->n_missed, record->n_bad,
           ending->summary->n_poses, ending->summary->n_dropped);
}

static void print_link(const exk_link_counts *link)
{
    printf("machine on the bus: %" PRId64 " answers lost, %" PRId64 " late, %" PRId64
           " repeated, %" PRId64 " out of order, %" PRId64 " foreign\n",
           link->n_lost, link->n_late, link->n_repeated, link->n_reordered, link->n_foreign);
}

static void print_commands(const exk_command_counts *command)
{
    printf("commands: %" PRId64 " taken", command->n_taken);
    for (int i = 0; i < EXK_REFUSED_COUNT; i++) {
        if (command->n_refused[i] > 0) {
            printf(", %" PRId64 " refused: %s", command->n_refused[i],
                   exk_refusal_name((exk_refusal)i));
        }
    }
    printf("\n");
}

static void print_histogram(const char *what, const exk_histogram *hist)
{
    printf("%s p50 %.1f us, p99 %.1f us, p99.9 %.1f us, max %.1f us\n", what,
           1e-3 * (double)exk_histogram_quantile_ns(hist, 0.5),
           1e-3 * (double)exk_histogram_quantile_ns(hist, 0.99),
           1e-3 * (double)exk_histogram_quantile_ns(hist, 0.999),
           1e-3 * (double)exk_histogram_quantile_ns(hist, 1.0));
}

/* Nothing is left of the way from where the tool is to the clearance of its hole. */
static bool is_clear(const exk_rig *rig)
{
    const exk_motion *m = &rig->loop.motion;
    exk_segment way;
    return m->retracts ? m->step >= m->way.n_ticks
                       : exk_plan_retract(&rig->plan, m->j, &way) == EXK_OK && way.n_ticks == 0;
}

/* What became of the tool when the run ended: by itself, or earlier by a signal. */
static const char *what_became(const exk_rig *rig)
{
    const exk_loop *loop = &rig->loop;
    if (loop->report.cause != EXK_CAUSE_SENSOR) {
        return "the last good command was held";
    }
    if (loop->motion.mode == EXK_MOTION_RETRACT) {
        return "the tool was on its way out of the part";
    }
    if (loop->motion.mode != EXK_MOTION_OUT) {
        return "the tool had not begun its way out of the part";
    }
    return is_clear(rig) ? "the tool is out of the part, at rest"
                         : "the tool is still in the part: its way out was broken off";
}

static void print_fault(const loop_ending *ending)
{
    const exk_loop_report *loop = &ending->record->loop;
    char text[EXK_FAULT_TEXT_MAX];
    exk_fault_text(&loop->fault, text, sizeof text);
    fprintf(stderr, "exk-loop: fault: %s\nexk-loop: %s\n", text, what_became(ending->rig));
}

void loop_summary_print(const loop_ending *ending, bool quiet)
{
    print_accuracy(ending);
    if (!quiet) {
        print_counts(ending);
    }
    if (!quiet && ending->on_link) {
        print_link(&ending->record->bus.link);
    }
    if (!quiet && ending->took_commands) {
        print_commands(&ending->record->bus.command);
    }
    if (!quiet && ending->lateness != NULL) {
        print_histogram("wake-up lateness", ending->lateness);
        print_histogram("step time       ", ending->step_time);
    }
    if (ending->k_fault >= 0) {
        print_fault(ending);
    }
    if (ending->signal != 0) {
        fprintf(stderr, "exk-loop: stopped by %s at tick %" PRId64 "%s\n",
                strsignal(ending->signal), ending->record->sample.k,
                ending->has_log ? "; the log is complete" : "");
    }
}
