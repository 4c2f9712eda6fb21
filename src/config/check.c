#include "check.h"

#include <math.h>
#include <stddef.h>
#include <stdio.h>
#include <string.h>

#include "exk/job_csv.h"
#include "exk/units.h"
#include "value.h"

enum { ALLOWED_SIZE = 96 };

/* A number for a message, rounded to three places of its unit. */
typedef struct {
    char text[EXK_NUMBER_SIZE];
} shown_number;

static shown_number show(double value)
{
    shown_number shown;
    exk_number_write(round(value * 1e3) / 1e3, &exk_unit_none, shown.text);
    return shown;
}

static int line_of(const exk_profile_reader *r, exk_section_id section, int instance,
                   const char *name)
{
    const int line = exk_line_of_key(r, section, instance, name);
    return line != 0 ? line : r->section_line[instance][section];
}

static bool given(const exk_profile_reader *r, exk_section_id section, int instance,
                  const char *name)
{
    return exk_line_of_key(r, section, instance, name) != 0;
}

static bool refused(const exk_profile_reader *r, exk_section_id section, const char *name)
{
    const size_t i = exk_key_find(section, name);
    return i < exk_key_count() && r->refused[0][i];
}

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
    if (!given(r, EXK_IN_JOB, 0, "plane_z_mm")) {
        p->job.pattern.center_m[EXK_Z] = exk_profile_plane_z(p);
    }
}

/* The two keys of a published ratio (geometry.h). */
typedef struct {
    const char *start; /* of the fault's name */
    const char *over;
    const char *under;
    size_t over_at;
    size_t under_at;
} ratio_keys;

#define LENGTH(field) offsetof(exk_geometry, field)
static const ratio_keys ratios[] = {
    {"p1 ", "d1_mm", "d5_mm", LENGTH(d1_m), LENGTH(d5_m)},
    {"p2 ", "d2_mm", "d1_mm", LENGTH(d2_m), LENGTH(d1_m)},
    {"p3 ", "d3_mm", "d1_mm", LENGTH(d3_m), LENGTH(d1_m)},
    {"p4 ", "d4_mm", "d3_mm", LENGTH(d4_m), LENGTH(d3_m)},
};

static double length_mm(const exk_geometry *geo, size_t at)
{
    double value_m;
    memcpy(&value_m, (const char *)geo + at, sizeof(value_m));
    return value_m * EXK_MM_PER_M;
}

/* "0.5 to 1", or "0.75" where one value alone is allowed. */
typedef struct {
    char text[2 * EXK_NUMBER_SIZE + 4];
} shown_span;

static shown_span show_span(double min, double max)
{
    shown_span span;
    const bool one = strcmp(show(min).text, show(max).text) == 0;
    snprintf(span.text, sizeof(span.text), "%s%s%s", show(min).text, one ? "" : " to ",
             one ? "" : show(max).text);
    return span;
}

/* Blames the key that the file gives, the upper one where it gives both or none, and says which
 * lengths of it would do. */
static void say_ratio(exk_profile_reader *r, const ratio_keys *keys,
                      const exk_geometry_fault *fault)
{
    const exk_geometry *geo = &r->profile.geometry;
    const double over = length_mm(geo, keys->over_at);
    const double under = length_mm(geo, keys->under_at);
    const bool upper =
        given(r, EXK_IN_MACHINE, 0, keys->over) || !given(r, EXK_IN_MACHINE, 0, keys->under);
    const char *name = upper ? keys->over : keys->under;
    const double length = upper ? over / fault->value : under * fault->value;
    const double least = upper ? length * fault->min : length / fault->max;
    const double most = upper ? length * fault->max : length / fault->min;
    exk_faults_add(&r->faults, line_of(r, EXK_IN_MACHINE, 0, name),
                   "[machine] %s: ratio %s out of range: found %s, allowed: %s (%s = %s, %s = "
                   "%s); choose %s %s",
                   name, fault->name, show(fault->value).text,
                   show_span(fault->min, fault->max).text, keys->over, show(over).text,
                   keys->under, show(under).text, name, show_span(least, most).text);
}

static const ratio_keys *find_ratio(const char *fault_name)
{
    for (size_t i = 0; i < sizeof(ratios) / sizeof(ratios[0]); i++) {
        if (strncmp(fault_name, ratios[i].start, strlen(ratios[i].start)) == 0) {
            return &ratios[i];
        }
    }
    return NULL;
}

static void check_geometry(exk_profile_reader *r)
{
    exk_geometry_fault faults[EXK_GEOMETRY_FAULTS_MAX];
    const size_t n = exk_geometry_faults(&r->profile.geometry, faults, EXK_GEOMETRY_FAULTS_MAX);
    for (size_t i = 0; i < n; i++) {
        const ratio_keys *keys = find_ratio(faults[i].name);
        if (keys != NULL && (refused(r, EXK_IN_MACHINE, keys->over) ||
                             refused(r, EXK_IN_MACHINE, keys->under))) {
            continue; /* said already */
        }
        if (keys != NULL) {
            say_ratio(r, keys, &faults[i]);
        } else { /* the table has the same bounds, so that only rounding can lead here */
            exk_faults_add(&r->faults, r->section_line[0][EXK_IN_MACHINE],
                           "[machine] %s: out of range", faults[i].name);
        }
    }
}

static void check_job(exk_profile_reader *r)
{
    const exk_job_config *job = &r->profile.job;
    if (job->kind == EXK_JOB_CSV && !given(r, EXK_IN_JOB, 0, "file")) {
        exk_faults_add(&r->faults, line_of(r, EXK_IN_JOB, 0, "kind"),
                       "[job]: missing key file; kind = csv needs the name of a CSV of holes");
    }
    const long n_holes = (long)job->pattern.rows * job->pattern.columns;
    if (job->kind == EXK_JOB_GRID && n_holes > EXK_MAX_HOLES) {
        exk_faults_add(&r->faults, line_of(r, EXK_IN_JOB, 0, "rows"),
                       "[job] rows: too many holes: found rows * columns = %ld, allowed %d",
                       n_holes, (int)EXK_MAX_HOLES);
    }
    if (exk_plan_check(&job->plan) != EXK_OK) {
        exk_faults_add(
            &r->faults, line_of(r, EXK_IN_JOB, 0, "feed_mmps"),
            "[job]: the motion cannot be planned; check feeds, acceleration, lengths");
    }
}

/* The rule is exk_pid_init's; this names the gain that breaks it. */
static void check_feedback(exk_profile_reader *r)
{
    static const char unstable[] = "unstable with one step of delay";
    const exk_pid_config *pid = &r->profile.feedback.pid;
    const double ki_max = 2.0 * (1.0 - pid->kp) / pid->dt_s;
    exk_feedback trial;
    if (exk_feedback_init(&trial, &r->profile.feedback) == EXK_OK) {
        return;
    }
    if (!(pid->kp < 1.0)) {
        exk_faults_add(&r->faults, line_of(r, EXK_IN_CONTROL, 0, "kp"),
                       "[control] kp: %s: found %s, allowed: below 1", unstable,
                       show(pid->kp).text);
    } else if (!(pid->ki < ki_max)) {
        exk_faults_add(
            &r->faults, line_of(r, EXK_IN_CONTROL, 0, "ki_per_s"),
            "[control] ki_per_s: %s: found %s with kp = %s, allowed: below 2 (1 - kp) "
            "rate_Hz = %s 1/s",
            unstable, show(pid->ki).text, show(pid->kp).text, show(ki_max).text);
    } else {
        exk_faults_add(
            &r->faults, line_of(r, EXK_IN_CONTROL, 0, "kd_s"),
            "[control] kd_s: %s: found %s with kp = %s, ki_per_s = %s, d_filter_s = %s; "
            "lower kd_s or lengthen d_filter_s",
            unstable, show(pid->kd).text, show(pid->kp).text, show(pid->ki).text,
            show(pid->d_filter_s).text);
    }
}

static void check_learning(exk_profile_reader *r)
{
    const exk_ilc_config *ilc = &r->profile.ilc;
    if (exk_ilc_check(ilc) == EXK_OK) {
        return;
    }
    const double nyquist_half_Hz = 0.25 / ilc->dt_s;
    const bool cutoff = !(ilc->cutoff_Hz < nyquist_half_Hz);
    if (cutoff) {
        exk_faults_add(
            &r->faults, line_of(r, EXK_IN_CONTROL, 0, "ilc_cutoff_Hz"),
            "[control] ilc_cutoff_Hz: out of range: found %s, allowed: below rate_Hz/4 = "
            "%s Hz",
            show(ilc->cutoff_Hz).text, show(nyquist_half_Hz).text);
        return;
    }
    exk_faults_add(
        &r->faults, line_of(r, EXK_IN_CONTROL, 0, "ilc_gain"),
        "[control] ilc_gain: learning would not settle: found ilc_gain = %s, ilc_d_gain_s "
        "rate_Hz = %s, allowed: ilc_gain + 2 ilc_d_gain_s rate_Hz below 2",
        show(ilc->gain).text, show(ilc->d_gain_s / ilc->dt_s).text);
}

/* Says what is wrong with one amplitude key that was given; wanted is the one that fits. */
static void say_amplitude(exk_profile_reader *r, int instance, const exk_key *key,
                          const char *wanted)
{
    const exk_disturbance_config *d = &r->profile.twin.disturbance[instance];
    const int line = exk_line_of_key(r, EXK_IN_DISTURBANCE, instance, key->name);
    if (wanted == NULL) {
        exk_faults_add(&r->faults, line,
                       "[disturbance.%d] %s: wave = none takes none; remove it", instance + 1,
                       key->name);
    } else {
        exk_faults_add(&r->faults, line,
                       "[disturbance.%d] %s: does not fit wave = %s with order = %d; write %s",
                       instance + 1, key->name, exk_wave_name(d->wave), d->order, wanted);
    }
}

static bool check_amplitudes(exk_profile_reader *r, int instance, const char *wanted)
{
    bool good = true;
    for (size_t i = 0; i < exk_key_count(); i++) {
        const exk_key *key = exk_key_at(i);
        const bool fits = wanted != NULL && strcmp(key->name, wanted) == 0;
        if (exk_key_is_amplitude(key) && r->key_line[instance][i] != 0 && !fits) {
            say_amplitude(r, instance, key, wanted);
            good = false;
        }
    }
    return good;
}

static void say_missing_number(exk_profile_reader *r, int instance, const char *name)
{
    const exk_disturbance_config *d = &r->profile.twin.disturbance[instance];
    exk_faults_add(&r->faults, r->section_line[instance][EXK_IN_DISTURBANCE],
                   "[disturbance.%d]: missing key %s; wave = %s with order = %d needs it",
                   instance + 1, name, exk_wave_name(d->wave), d->order);
}

static void check_disturbance(exk_profile_reader *r, int instance)
{
    const exk_disturbance_config *d = &r->profile.twin.disturbance[instance];
    const char *wanted = exk_amplitude_name(d->wave, d->order);
    if (check_amplitudes(r, instance, wanted) && wanted != NULL &&
        !given(r, EXK_IN_DISTURBANCE, instance, wanted)) {
        say_missing_number(r, instance, wanted);
    }
    if (d->wave == EXK_WAVE_SINE && !given(r, EXK_IN_DISTURBANCE, instance, "freq_Hz")) {
        say_missing_number(r, instance, "freq_Hz");
    }
}

static void check_sources(exk_profile_reader *r)
{
    if (r->profile.timing.from == EXK_FROM_REPLAY && !given(r, EXK_IN_LOOP, 0, "replay_file")) {
        exk_faults_add(
            &r->faults, line_of(r, EXK_IN_LOOP, 0, "source"),
            "[loop]: missing key replay_file; source = replay needs the log to read");
    }
}

static void check_commands(exk_profile_reader *r)
{
    if (r->profile.command.allow && !given(r, EXK_IN_COMMAND, 0, "key_file")) {
        exk_faults_add(&r->faults, line_of(r, EXK_IN_COMMAND, 0, "allow"),
                       "[command]: missing key key_file; allow = yes needs the key that "
                       "commands are checked with (exk-command keygen FILE makes one)");
    }
    if (r->profile.command.wait && !r->profile.command.allow) {
        exk_faults_add(&r->faults, line_of(r, EXK_IN_COMMAND, 0, "wait"),
                       "[command] wait: yes would wait for ever: no command is allowed; add "
                       "allow = yes");
    }
}

static void check_ring(exk_profile_reader *r)
{
    const int slots = r->profile.telemetry.ring_slots;
    if ((slots & (slots - 1)) != 0) {
        exk_faults_add(
            &r->faults, line_of(r, EXK_IN_TELEMETRY, 0, "ring_slots"),
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
            exk_faults_add(&r->faults, line_of(r, EXK_IN_LIMITS, 0, names[i]),
                           "[limits] %s: not below its max: found %s, allowed: below %s mm",
                           names[i], show(limits->box_min_m[i] * EXK_MM_PER_M).text,
                           show(limits->box_max_m[i] * EXK_MM_PER_M).text);
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
            &r->faults, line_of(r, EXK_IN_LIMITS, 0, "leg_margin_mm"),
            "[limits] leg_margin_mm: leaves no stroke: found %s, allowed: below half "
            "of d5_mm = %s mm",
            show(margin_m * EXK_MM_PER_M).text, show(most_m * EXK_MM_PER_M).text);
    }
}

static void check_delays(exk_profile_reader *r)
{
    const double most_s = EXK_INJECT_DELAY_MAX * r->profile.timing.dt_s;
    for (int n = 0; n < EXK_MAX_INJECTED; n++) {
        const exk_inject_fault *fault = &r->profile.inject.fault[n];
        if (fault->kind == EXK_INJECT_DELAY && !(fault->delay_s <= most_s)) {
            exk_faults_add(&r->faults, line_of(r, EXK_IN_FAULT, n, "delay_s"),
                           "[fault.%d] delay_s: out of range: found %s, allowed: up to %d "
                           "ticks = %s s",
                           n + 1, show(fault->delay_s).text, (int)EXK_INJECT_DELAY_MAX,
                           show(most_s).text);
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
        {EXK_IN_NOTHING, check_geometry}, {EXK_IN_JOB, check_job},
        {EXK_IN_CONTROL, check_feedback}, {EXK_IN_CONTROL, check_learning},
        {EXK_IN_LOOP, check_sources},     {EXK_IN_TELEMETRY, check_ring},
        {EXK_IN_COMMAND, check_commands}, {EXK_IN_LIMITS, check_box},
        {EXK_IN_LIMITS, check_margin},    {EXK_IN_FAULT, check_delays},
    };
    check_required(reader);
    derive(reader);
    for (size_t i = 0; i < sizeof(rules) / sizeof(rules[0]); i++) {
        const bool needs_rate = rules[i].section == EXK_IN_CONTROL;
        if (!any_refused(reader, rules[i].section, 0) &&
            !(needs_rate && refused(reader, EXK_IN_LOOP, "rate_Hz"))) {
            rules[i].check(reader);
        }
    }
    for (int n = 0; n < EXK_MAX_DISTURBANCES; n++) {
        if (reader->section_line[n][EXK_IN_DISTURBANCE] != 0 && !reader->has_unknown[n] &&
            !any_refused(reader, EXK_IN_DISTURBANCE, n)) {
            check_disturbance(reader, n);
        }
    }
}
