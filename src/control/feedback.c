#include "exk/feedback.h"

exk_feedback_config exk_feedback_default(void)
{
    return (exk_feedback_config){.kind = EXK_FEEDBACK_PID, .pid = exk_pid_default()};
}

exk_err exk_feedback_init(exk_feedback *fb, const exk_feedback_config *cfg)
{
    if ((unsigned)cfg->kind >= EXK_FEEDBACK_COUNT) {
        return EXK_ERR_ARG;
    }
    exk_feedback ready = {.kind = cfg->kind};
    for (int i = 0; i < EXK_N_AXES && cfg->kind == EXK_FEEDBACK_PID; i++) {
        const exk_err err = exk_pid_init(&ready.pid[i], &cfg->pid);
        if (err != EXK_OK) {
            return err;
        }
    }
    *fb = ready;
    return EXK_OK;
}

void exk_feedback_reset(exk_feedback *fb)
{
    for (int i = 0; i < EXK_N_AXES; i++) {
        exk_pid_reset(&fb->pid[i]);
    }
}

void exk_feedback_step(exk_feedback *fb, const double error_rad[EXK_N_AXES],
                       double correction_rad[EXK_N_AXES])
{
    for (int i = 0; i < EXK_N_AXES; i++) {
        correction_rad[i] =
            fb->kind == EXK_FEEDBACK_PID ? exk_pid_step(&fb->pid[i], error_rad[i]) : 0.0;
    }
}

void exk_feedback_rejoin(exk_feedback *fb, const double error_rad[EXK_N_AXES])
{
    for (int i = 0; i < EXK_N_AXES; i++) {
        exk_pid_rejoin(&fb->pid[i], error_rad[i]);
    }
}

void exk_feedback_preset(exk_feedback *fb, const double correction_rad[EXK_N_AXES])
{
    for (int i = 0; i < EXK_N_AXES; i++) {
        exk_pid_preset(&fb->pid[i], correction_rad[i], 0.0);
        fb->pid[i].has_last = false;
    }
}

const char *exk_feedback_name(exk_feedback_kind kind)
{
    static const char *const names[EXK_FEEDBACK_COUNT] = {
        [EXK_FEEDBACK_NONE] = "none",
        [EXK_FEEDBACK_PID] = "pid",
    };
    return (unsigned)kind < EXK_FEEDBACK_COUNT ? names[kind] : "unknown";
}
