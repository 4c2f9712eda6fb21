#include <inttypes.h>
#include <math.h>
#include <stdio.h>

#include "exk/rig.h"
#include "exk/store.h"
#include "ilc_tool.h"
#include "json_file.h"

typedef struct {
    double rms_rad[EXK_N_AXES];
    double max_rad[EXK_N_AXES];
} store_size;

static store_size measure(const exk_store *store)
{
    store_size size = {{0.0}, {0.0}};
    for (int i = 0; i < EXK_N_AXES; i++) {
        for (size_t k = 0; k < store->n_samples; k++) {
            size.rms_rad[i] += store->u_rad[i][k] * store->u_rad[i][k];
            size.max_rad[i] = fmax(size.max_rad[i], fabs(store->u_rad[i][k]));
        }
        size.rms_rad[i] = sqrt(size.rms_rad[i] / (double)store->n_samples);
    }
    return size;
}

static int show_json(const ilc_options *options, const exk_store *store, const store_size *size)
{
    char hash[24];
    snprintf(hash, sizeof hash, "%016" PRIx64, store->job_hash);
    json_t *root = json_pack(
        "{s:s, s:s, s:I, s:I, s:f, s:[f,f], s:[f,f]}", "file", options->input, "job_hash", hash,
        "iteration", (json_int_t)store->iteration, "n_samples", (json_int_t)store->n_samples,
        "dt_s", store->dt_s, "rms_rad", size->rms_rad[0], size->rms_rad[1], "max_rad",
        size->max_rad[0], size->max_rad[1]);
    char why[512];
    const int code = exk_json_write(root, "-", "file", why, sizeof why);
    json_decref(root);
    if (code != ILC_GOOD) {
        fprintf(stderr, "exk-ilc: %s\n", why);
    }
    return code;
}

static int load(const ilc_options *options, exk_store *store)
{
    char why[512];
    const exk_store_err err = exk_store_load(options->input, store, why, sizeof why);
    if (err != EXK_STORE_OK) {
        fprintf(stderr, "exk-ilc: %s\n", why);
        return err == EXK_STORE_IO ? ILC_IO : ILC_INPUT;
    }
    if (store->is_previous) {
        fprintf(stderr, "exk-ilc: %s\n", why);
    }
    return ILC_GOOD;
}

int ilc_show(const ilc_options *options)
{
    exk_store store;
    int code = load(options, &store);
    if (code != ILC_GOOD) {
        return code;
    }
    const store_size size = measure(&store);
    if (options->json) {
        code = show_json(options, &store, &size);
    } else {
        printf("job hash    %016" PRIx64 "\n", store.job_hash);
        printf("for run     %" PRIu32 "\n", store.iteration);
        printf("samples     %zu of %g s\n", store.n_samples, store.dt_s);
        printf("alpha       rms %.6f mrad, largest %.6f mrad\n", 1e3 * size.rms_rad[EXK_ALPHA],
               1e3 * size.max_rad[EXK_ALPHA]);
        printf("beta        rms %.6f mrad, largest %.6f mrad\n", 1e3 * size.rms_rad[EXK_BETA],
               1e3 * size.max_rad[EXK_BETA]);
    }
    exk_store_free(&store);
    return code;
}

static int match_profile(const ilc_options *options, const exk_store *store)
{
    exk_rig rig;
    char why[512];
    int code = exk_rig_open(&rig, options->profile);
    if (code != ILC_GOOD) {
        return code;
    }
    if (exk_store_match(store, rig.job_hash, rig.plan.cfg.dt_s, (size_t)rig.plan.n_ticks, why,
                        sizeof why) != EXK_STORE_OK) {
        fprintf(stderr, "%s: %s\n", options->input, why);
        code = ILC_INPUT;
    }
    exk_rig_close(&rig);
    return code;
}

int ilc_verify(const ilc_options *options)
{
    exk_store store;
    int code = load(options, &store);
    if (code != ILC_GOOD) {
        return code;
    }
    if (options->profile != NULL) {
        code = match_profile(options, &store);
    }
    if (code == ILC_GOOD && store.is_previous) {
        code = ILC_MISSED; /* load said why */
    } else if (code == ILC_GOOD) {
        printf("%s: whole%s\n", options->input,
               options->profile == NULL ? "" : ", and of this profile's job");
    }
    exk_store_free(&store);
    return code;
}
