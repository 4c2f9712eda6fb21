#include <stdio.h>

#include "csv_in.h"
#include "exk/input.h"
#include "exk/standard_streams.h"
#include "options.h"
#include "out_file.h"

enum { GOOD = 0, SOME_FAILED = 1, BAD_INPUT = 2, WHY_SIZE = 512 };

static kin_model model_of_profile(const exk_profile *profile)
{
    switch (profile->model) {
    case EXK_KIN_PENDULUM:
        return KIN_PENDULUM;
    case EXK_KIN_UNIVERSAL:
        return KIN_UNIVERSAL;
    case EXK_KIN_MACHINE:
    case EXK_KIN_COUNT:
    default:
        return KIN_MACHINE;
    }
}

/* The machine of the profile, or the default one; fills in what the options left to it. */
static int set_up(kin_options *options, exk_kin *kin)
{
    static exk_profile profile;
    exk_geometry geo = exk_geometry_default();
    if (options->profile != NULL) {
        const int rc = exk_input_profile(options->profile, &profile);
        if (rc != GOOD) {
            return rc;
        }
        geo = profile.geometry;
        options->model = options->has_model ? options->model : model_of_profile(&profile);
        options->wrist = options->has_wrist ? options->wrist : profile.wrist;
    }
    if (exk_kin_init(kin, kin_interface_of(options->model), options->wrist, &geo) != EXK_OK) {
        fprintf(stderr, "exk-kin: the geometry is outside the published ratios\n");
        return BAD_INPUT;
    }
    return GOOD;
}

static size_t count(const char *const *names)
{
    size_t n = 0;
    while (names[n] != NULL) {
        n++;
    }
    return n;
}

static void print_header(const kin_sum *sum)
{
    for (size_t i = 0; sum->out[i] != NULL; i++) {
        printf("%s,", sum->out[i]);
    }
    printf("status\n");
}

static void print_row(const double *out, size_t n_out, exk_err err)
{
    for (size_t i = 0; i < n_out; i++) {
        if (err == EXK_OK) {
            printf("%.17g", out[i] + 0.0); /* -0 is shown as 0 */
        }
        printf(",");
    }
    printf("%s\n", exk_err_name(err));
}

/* Row by row; returns an exit code, and its message in why where it is 2 or 3. */
static int run(const kin_sum *sum, const exk_kin *kin, exk_csv_in *csv, char *why)
{
    const size_t n_out = count(sum->out);
    long n_rows = 0, n_failed = 0;
    for (;; n_rows++) {
        double in[KIN_IN_MAX], out[KIN_OUT_MAX];
        bool more;
        const int rc = exk_csv_next(csv, in, &more, why, WHY_SIZE);
        if (rc != GOOD) {
            return rc;
        }
        if (!more) {
            break;
        }
        const exk_err err = sum->compute(kin, in, out);
        n_failed += err != EXK_OK;
        print_row(out, n_out, err);
    }
    if (n_failed > 0) {
        fprintf(stderr, "exk-kin: %ld of %ld rows without a solution, see status\n", n_failed,
                n_rows);
    }
    return n_failed > 0 ? SOME_FAILED : GOOD;
}

int main(int argc, char **argv)
{
    kin_options options;
    exk_kin kin;
    exk_standard_streams_hold();
    kin_options_parse(argc, argv, &options);
    int rc = set_up(&options, &kin);
    if (rc != GOOD) {
        return rc;
    }
    const kin_sum *sum = kin_sum_of(options.model, options.direction);
    char why[WHY_SIZE] = "";
    exk_csv_in csv;
    rc = exk_csv_open(&csv, stdin, "standard input", sum->in, count(sum->in), why, WHY_SIZE);
    if (rc == GOOD) {
        print_header(sum);
        rc = run(sum, &kin, &csv, why);
    }
    exk_csv_close(&csv);
    if (why[0] != '\0') {
        fprintf(stderr, "exk-kin: %s\n", why);
    }
    const int flushed = exk_stdout_flush("exk-kin");
    return flushed != GOOD ? flushed : rc;
}
