#include "check.h"

#include "check_parts.h"
#include "exk/job_csv.h"
#include "exk/units.h"
#include "value.h"

enum { ALLOWED_SIZE = 96 };
static bool any_refused(const exk_profile_reader *r, exk_section_id section, int instance)
{
    bool any = false;
    for (size_t i = 0; i < exk_key_count(); i++) {
        any = any || (exk_key_at(i)->section == section && r->refused[instance][i]);
    }
    return any;
}

static void say_missing(exk_profile_reader *r, const exk_key *key, int instance)
{
    char section[EXK_SECTION_SIZE];
    char allowed[ALLOWED_SIZE];
    exk_text text = exk_text_start(allowed, sizeof(allowed));
    const int line = r->section_line[instance][key->section];
    exk_section_label(key->section, instance, section);
    exk_value_add_allowed(key, "", &text);
    if (line == 0) {
        exk_faults_add(&r->faults, 0, "missing section [%s]; add it with %s = %s", section,
                       key->name, allowed);
    } else {
        exk_faults_add(&r->faults, line, "[%s]: missing key %s; allowed: %s", section,
                       key->name, allowed);
    }
}

static void check_required(exk_profile_reader *r)
{
    for (size_t i = 0; i < exk_key_count(); i++) {
        const exk_key *key = exk_key_at(i);
        const bool many = exk_section_of(key->section)->stem != NULL;
        for (int n = 0; key->required && n < EXK_INSTANCES_MAX; n++) {
            const bool asked = many ? r->section_line[n][key->section] != 0 : n == 0;
            if (asked && r->key_line[n][i] == 0) {
                say_missing(r, key, n);
            }
        }
    }
}

static void derive(exk_profile_reader *r)
{
    exk_profile *p = &r->profile;
    const double dt_s = 1.0 / p->timing.rate_Hz;
    p->timing.dt_s = dt_s;
    p->job.plan.dt_s = dt_s;
    p->twin.dt_s = dt_s;
    p->feedback.pid.dt_s = dt_s;
    p->ilc.dt_s = dt_s;
    if (!exk_check_given(r, EXK_IN_JOB, 0, "plane_z_mm")) {
        p->job.pattern.center_m[EXK_Z] = exk_profile_plane_z(p);
    }
}

static void check_job(exk_profile_reader *r)
{
    const exk_job_config *job = &r->profile.job;
    if (job->kind == EXK_JOB_CSV && !exk_check_given(r, EXK_IN_JOB, 0, "file")) {
        exk_faults_add(&r->faults, exk_check_line(r, EXK_IN_JOB, 0, "kind"),
                       "[job]: missing key file; kind = csv needs the name of a CSV of holes");
    }
    const long n_holes = (long)job->pattern.rows * job->pattern.columns;
    if (job->kind == EXK_JOB_GRID && n_holes > EXK_MAX_HOLES) {
        exk_faults_add(&r->faults, exk_check_line(r, EXK_IN_JOB, 0, "rows"),
                       "[job] rows: too many holes: found rows * columns = %ld, allowed %d",
                       n_holes, (int)EXK_MAX_HOLES);
    }
    if (exk_plan_check(&job->plan) != EXK_OK) {
        exk_faults_add(
            &r->faults, exk_check_line(r, EXK_IN_JOB, 0, "feed_mmps"),
            "[job]: the motion cannot be planned; check feeds, acceleration, lengths");
    }
}

static void check_sources(exk_profile_reader *r)
{
    if (r->profile.timing.from == EXK_FROM_REPLAY &&
        !exk_check_given(r, EXK_IN_LOOP, 0, "replay_file")) {
        exk_faults_add(
            &r->faults, exk_check_line(r, EXK_IN_LOOP, 0, "source"),
            "[loop]: missing key replay_file; source = replay needs the log to read");
    }
}

static void check_commands(exk_profile_reader *r)
{
    if (r->profile.command.allow && !exk_check_given(r, EXK_IN_COMMAND, 0, "key_file")) {
        exk_faults_add(&r->faults, exk_check_line(r, EXK_IN_COMMAND, 0, "allow"),
                       "[command]: missing key key_file; allow = yes needs the key that "
                       "commands are checked with (exk-command keygen FILE makes one)");
    }
    if (r->profile.command.wait && !r->profile.command.allow) {
        exk_faults_add(&r->faults, exk_check_line(r, EXK_IN_COMMAND, 0, "wait"),
                       "[command] wait: yes would wait for ever: no command is allowed; add "
                       "allow = yes");
    }
}

static void check_ring(exk_profile_reader *r)
{
    const int slots = r->profile.telemetry.ring_slots;
    if ((slots & (slots - 1)) != 0) {
        exk_faults_add(
            &r->faults, exk_check_line(r, EXK_IN_TELEMETRY, 0, "ring_slots"),
            "[telemetry] ring_slots: not a power of two: found %d, allowed: 2, 4, 8, "
            "... 4194304",
            slots);
    }
}

static void check_box(exk_profile_reader *r)
{
    static const char *const names[] = {"x_min_mm", "y_min_mm", "z_min_mm"};
    const exk_limits_keys *limits = &r->profile.limits;
    for (int i = 0; i < 3; i++) {
        if (!(limits->box_min_m[i] < limits->box_max_m[i])) {
            exk_faults_add(&r->faults, exk_check_line(r, EXK_IN_LIMITS, 0, names[i]),
                           "[limits] %s: not below its max: found %s, allowed: below %s mm",
                           names[i], exk_check_show(limits->box_min_m[i] * EXK_MM_PER_M).text,
                           exk_check_show(limits->box_max_m[i] * EXK_MM_PER_M).text);
        }
    }
}

/* A machine whose legs may be nowhere could not be set up. */
static void check_margin(exk_profile_reader *r)
{
    const double margin_m = r->profile.limits.leg_margin_m;
    const double most_m = 0.5 * r->profile.geometry.d5_m;
    if (r->profile.model == EXK_KIN_MACHINE && !(margin_m < most_m)) {
        exk_faults_add(
            &r->faults, exk_check_line(r, EXK_IN_LIMITS, 0, "leg_margin_mm"),
            "[limits] leg_margin_mm: leaves no stroke: found %s, allowed: below half "
            "of d5_mm = %s mm",
            exk_check_show(margin_m * EXK_MM_PER_M).text,
            exk_check_show(most_m * EXK_MM_PER_M).text);
    }
}

static void check_delays(exk_profile_reader *r)
{
    const double most_s = EXK_INJECT_DELAY_MAX * r->profile.timing.dt_s;
    for (int n = 0; n < EXK_MAX_INJECTED; n++) {
        const exk_inject_fault *fault = &r->profile.inject.fault[n];
        if (fault->kind == EXK_INJECT_DELAY && !(fault->delay_s <= most_s)) {
            exk_faults_add(&r->faults, exk_check_line(r, EXK_IN_FAULT, n, "delay_s"),
                           "[fault.%d] delay_s: out of range: found %s, allowed: up to %d "
                           "ticks = %s s",
                           n + 1, exk_check_show(fault->delay_s).text,
                           (int)EXK_INJECT_DELAY_MAX, exk_check_show(most_s).text);
        }
    }
}

typedef struct {
    exk_section_id section;
    void (*check)(exk_profile_reader *r);
} rule;

/* A rule between values is asked only when each of them is good; the ratios look for themselves. */
void exk_check_profile(exk_profile_reader *reader)
{
    static const rule rules[] = {
        {EXK_IN_NOTHING, exk_check_geometry}, {EXK_IN_JOB, check_job},
        {EXK_IN_CONTROL, exk_check_feedback}, {EXK_IN_CONTROL, exk_check_learning},
        {EXK_IN_LOOP, check_sources},         {EXK_IN_TELEMETRY, check_ring},
        {EXK_IN_COMMAND, check_commands},     {EXK_IN_LIMITS, check_box},
        {EXK_IN_LIMITS, check_margin},        {EXK_IN_FAULT, check_delays},
    };
    check_required(reader);
    derive(reader);
    for (size_t i = 0; i < sizeof(rules) / sizeof(rules[0]); i++) {
        const bool needs_rate = rules[i].section == EXK_IN_CONTROL;
        if (!any_refused(reader, rules[i].section, 0) &&
            !(needs_rate && exk_check_refused(reader, EXK_IN_LOOP, "rate_Hz"))) {
            rules[i].check(reader);
        }
    }
    for (int n = 0; n < EXK_MAX_DISTURBANCES; n++) {
        if (reader->section_line[n][EXK_IN_DISTURBANCE] != 0 && !reader->has_unknown[n] &&
            !any_refused(reader, EXK_IN_DISTURBANCE, n)) {
            exk_check_disturbance(reader, n);
        }
    }
}
