#define _POSIX_C_SOURCE 200809L
#include "exk/rig.h"

#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "exk/excess.h"
#include "exk/input.h"
#include "exk/job_csv.h"
#include "exk/pendulum.h"
#include "exk/store.h"
#include "exk/units.h"

enum { EXIT_INPUT = 2, EXIT_IO = 3 };

static int csv_holes(exk_rig *rig, const char *profile_path)
{
    char path[2 * EXK_PATH_MAX];
    exk_fault faults[EXK_FAULTS_MAX];
    size_t n_faults = 0;
    exk_input_beside(profile_path, rig->profile.job.file, path, sizeof path);
    char *text = NULL;
    const int code = exk_input_read(path, &text);
    if (code != 0) {
        return code;
    }
    const exk_err err =
        exk_job_csv_parse(text, rig->profile.job.pattern.center_m[EXK_Z], rig->holes,
                          EXK_MAX_HOLES, &rig->n_holes, faults, EXK_FAULTS_MAX, &n_faults);
    free(text);
    if (err != EXK_OK) {
        exk_input_print(path, faults, n_faults);
        return EXIT_INPUT;
    }
    if (rig->profile.job.order == EXK_ORDER_SERPENTINE) {
        exk_job_serpentine(rig->holes, rig->n_holes, rig->profile.job.row_gap_m);
    }
    return 0;
}

static int make_holes(exk_rig *rig, const char *path)
{
    const exk_job_config *job = &rig->profile.job;
    exk_err err = EXK_OK;
    if (job->kind == EXK_JOB_CSV) {
        return csv_holes(rig, path);
    }
    if (job->kind == EXK_JOB_GRID) {
        err = exk_job_grid(&job->pattern, rig->holes, EXK_MAX_HOLES, &rig->n_holes);
    } else {
        err = exk_job_rectangle(&job->pattern, rig->holes, EXK_MAX_HOLES, &rig->n_holes);
    }
    if (err != EXK_OK) {
        fprintf(stderr, "%s: [job] cannot be laid out: %s (at most %d holes)\n", path,
                exk_err_name(err), EXK_MAX_HOLES);
        return EXIT_INPUT;
    }
    return 0;
}

static int make_plan(exk_rig *rig, const char *path)
{
    const size_t n_segments = exk_plan_segments_needed(rig->n_holes);
    rig->segments = calloc(n_segments, sizeof *rig->segments);
    if (rig->segments == NULL) {
        fprintf(stderr, "%s: out of memory for %zu holes\n", path, rig->n_holes);
        return EXIT_IO;
    }
    const exk_err err = exk_plan_init(&rig->plan, &rig->profile.job.plan, rig->holes,
                                      rig->n_holes, rig->segments, n_segments);
    if (err != EXK_OK) {
        fprintf(stderr, "%s: [job] cannot be planned: %s\n", path, exk_err_name(err));
        return EXIT_INPUT;
    }
    return 0;
}

/* "leg 2 would be 1402.110 mm, limit 1350.000 mm", or the reason alone. */
static void say_excess(const exk_kin *kin, const exk_tool *tool, exk_err err, char *out,
                       size_t size)
{
    static const char *const angles[EXK_N_AXES] = {"alpha", "beta"};
    exk_excess excess;
    if (kin->model != EXK_KIN_MACHINE && err == EXK_ERR_LIMIT) {
        snprintf(out, size, "alpha or beta would be beyond %.1f deg",
                 EXK_PENDULUM_ANGLE_MAX_RAD / EXK_RAD_PER_DEG);
    } else if (!exk_excess_of_tool(kin, tool, &excess)) {
        snprintf(out, size, "%s", exk_err_name(err));
    } else if (excess.is_leg) {
        snprintf(out, size, "leg %d would be %.3f mm long, limit %.3f mm", excess.index + 1,
                 excess.value * EXK_MM_PER_M, excess.limit * EXK_MM_PER_M);
    } else {
        snprintf(out, size, "%s would be %.3f deg, limit %.3f deg", angles[excess.index],
                 excess.value / EXK_RAD_PER_DEG, excess.limit / EXK_RAD_PER_DEG);
    }
}

static void name_unreachable(const exk_rig *rig, const char *path, int64_t k, exk_err err)
{
    exk_ref ref;
    char reason[96];
    exk_plan_at(&rig->plan, k, &ref);
    say_excess(&rig->kin, &ref.tool, err, reason, sizeof reason);
    fprintf(stderr,
            "%s: hole %" PRId32 ": the machine cannot %s it at x %.3f y %.3f z %.3f mm: %s; "
            "move the hole or change [machine]\n",
            path, rig->holes[ref.hole].id,
            ref.phase == EXK_PHASE_TRAVEL ? "travel to" : "work on",
            ref.tool.tip_m[EXK_X] * EXK_MM_PER_M, ref.tool.tip_m[EXK_Y] * EXK_MM_PER_M,
            ref.tool.tip_m[EXK_Z] * EXK_MM_PER_M, reason);
}

/* Every tick of the plan goes through the inverse; each hole is named once. */
static int check_reach(const exk_rig *rig, const char *path)
{
    int32_t named = -1;
    int n_named = 0;
    for (int64_t k = 0; k < rig->plan.n_ticks; k++) {
        exk_ref ref;
        exk_joints joints;
        exk_plan_at(&rig->plan, k, &ref);
        const exk_err err = exk_kin_inverse(&rig->kin, &ref.tool, &joints);
        if (err != EXK_OK && ref.hole != named) {
            named = ref.hole;
            if (n_named++ < EXK_FAULTS_MAX) {
                name_unreachable(rig, path, k, err);
            }
        }
    }
    return n_named > 0 ? EXIT_INPUT : 0;
}

static int hash_job(exk_rig *rig, const char *path)
{
    const size_t length =
        exk_profile_job_text(&rig->profile, rig->holes, rig->n_holes, NULL, 0);
    char *text = malloc(length + 1);
    if (text == NULL) {
        fprintf(stderr, "%s: out of memory\n", path);
        return EXIT_IO;
    }
    exk_profile_job_text(&rig->profile, rig->holes, rig->n_holes, text, length + 1);
    rig->job_hash = exk_store_hash(text, length);
    free(text);
    return 0;
}

static int open_replay(exk_rig *rig, const char *profile_path)
{
    char path[2 * EXK_PATH_MAX];
    char why[256];
    if (rig->profile.timing.from != EXK_FROM_REPLAY) {
        return 0;
    }
    exk_input_beside(profile_path, rig->profile.timing.replay_file, path, sizeof path);
    if (!exk_replay_open(&rig->replay, path, why, sizeof why)) {
        fprintf(stderr, "%s\n", why);
        return EXIT_INPUT;
    }
    return 0;
}

static int build(exk_rig *rig, const char *path, int (*holes_from)(exk_rig *, const char *))
{
    const exk_profile *profile = &rig->profile;
    rig->from = profile->timing.from;
    const exk_err err =
        exk_kin_init(&rig->kin, profile->model, profile->wrist, &profile->geometry);
    if (err != EXK_OK) {
        fprintf(stderr, "%s: [machine] is refused: %s\n", path, exk_err_name(err));
        return EXIT_INPUT;
    }
    int code = holes_from(rig, path);
    code = code != 0 ? code : make_plan(rig, path);
    code = code != 0 ? code : check_reach(rig, path);
    code = code != 0 ? code : hash_job(rig, path);
    return code != 0 ? code : open_replay(rig, path);
}

static bool lend_holes(exk_rig *rig)
{
    *rig = (exk_rig){.n_holes = 0};
    rig->holes = calloc(EXK_MAX_HOLES, sizeof *rig->holes);
    return rig->holes != NULL;
}

int exk_rig_open(exk_rig *rig, const char *profile_path)
{
    if (!lend_holes(rig)) {
        fprintf(stderr, "%s: out of memory\n", profile_path);
        return EXIT_IO;
    }
    int code = exk_input_profile(profile_path, &rig->profile);
    code = code != 0 ? code : build(rig, profile_path, make_holes);
    if (code != 0) {
        exk_rig_close(rig);
    }
    return code;
}

static int holes_given(exk_rig *rig, const char *path)
{
    (void)path;
    return rig->n_holes > 0 ? 0 : EXIT_INPUT;
}

int exk_rig_open_text(exk_rig *rig, const char *name, const char *text, const exk_hole *holes,
                      size_t n_holes)
{
    if (n_holes > EXK_MAX_HOLES || !lend_holes(rig)) {
        fprintf(stderr, "%s: %zu holes, at most %d are allowed\n", name, n_holes,
                EXK_MAX_HOLES);
        return EXIT_INPUT;
    }
    memcpy(rig->holes, holes, n_holes * sizeof *holes);
    rig->n_holes = n_holes;
    int code = exk_input_parse(name, text, &rig->profile);
    code = code != 0 ? code : build(rig, name, holes_given);
    if (code != 0) {
        exk_rig_close(rig);
    }
    return code;
}

void exk_rig_close(exk_rig *rig)
{
    exk_replay_close(&rig->replay);
    free(rig->captured);
    free(rig->segments);
    free(rig->holes);
    *rig = (exk_rig){.n_holes = 0};
}

int64_t exk_rig_run_id(const exk_rig *rig, exk_realisation which)
{
    char text[128];
    const int length =
        snprintf(text, sizeof text, "%016" PRIx64 " %" PRIu64 " %" PRIu32 " %" PRIu32,
                 rig->job_hash, which.seed, which.series, which.run);
    return (int64_t)(exk_store_hash(text, (size_t)length) >> 1);
}
