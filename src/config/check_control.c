#include "check_parts.h"

/* The rule is exk_pid_init's; this names the gain that breaks it. */
void exk_check_feedback(exk_profile_reader *r)
{
    static const char unstable[] = "unstable with one step of delay";
    const exk_pid_config *pid = &r->profile.feedback.pid;
    const double ki_max = 2.0 * (1.0 - pid->kp) / pid->dt_s;
    exk_feedback trial;
    if (exk_feedback_init(&trial, &r->profile.feedback) == EXK_OK) {
        return;
    }
    if (!(pid->kp < 1.0)) {
        exk_faults_add(&r->faults, exk_check_line(r, EXK_IN_CONTROL, 0, "kp"),
                       "[control] kp: %s: found %s, allowed: below 1", unstable,
                       exk_check_show(pid->kp).text);
    } else if (!(pid->ki < ki_max)) {
        exk_faults_add(
            &r->faults, exk_check_line(r, EXK_IN_CONTROL, 0, "ki_per_s"),
            "[control] ki_per_s: %s: found %s with kp = %s, allowed: below 2 (1 - kp) "
            "rate_Hz = %s 1/s",
            unstable, exk_check_show(pid->ki).text, exk_check_show(pid->kp).text,
            exk_check_show(ki_max).text);
    } else {
        exk_faults_add(
            &r->faults, exk_check_line(r, EXK_IN_CONTROL, 0, "kd_s"),
            "[control] kd_s: %s: found %s with kp = %s, ki_per_s = %s, d_filter_s = %s; "
            "lower kd_s or lengthen d_filter_s",
            unstable, exk_check_show(pid->kd).text, exk_check_show(pid->kp).text,
            exk_check_show(pid->ki).text, exk_check_show(pid->d_filter_s).text);
    }
}

void exk_check_learning(exk_profile_reader *r)
{
    const exk_ilc_config *ilc = &r->profile.ilc;
    if (exk_ilc_check(ilc) == EXK_OK) {
        return;
    }
    const double nyquist_half_Hz = 0.25 / ilc->dt_s;
    const bool cutoff = !(ilc->cutoff_Hz < nyquist_half_Hz);
    if (cutoff) {
        exk_faults_add(
            &r->faults, exk_check_line(r, EXK_IN_CONTROL, 0, "ilc_cutoff_Hz"),
            "[control] ilc_cutoff_Hz: out of range: found %s, allowed: below rate_Hz/4 = "
            "%s Hz",
            exk_check_show(ilc->cutoff_Hz).text, exk_check_show(nyquist_half_Hz).text);
        return;
    }
    exk_faults_add(
        &r->faults, exk_check_line(r, EXK_IN_CONTROL, 0, "ilc_gain"),
        "[control] ilc_gain: learning would not settle: found ilc_gain = %s, ilc_d_gain_s "
        "rate_Hz = %s, allowed: ilc_gain + 2 ilc_d_gain_s rate_Hz below 2",
        exk_check_show(ilc->gain).text, exk_check_show(ilc->d_gain_s / ilc->dt_s).text);
}
