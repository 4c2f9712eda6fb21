/* exk-loop: the controller process. */
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>

#include "exk/args.h"
#include "exk/rig.h"
#include "exk/standard_streams.h"
#include "exk/store.h"
#include "options.h"
#include "run.h"

enum { EXIT_INPUT = 2, EXIT_IO = 3 };

static int print_profile(const exk_rig *rig)
{
    const size_t length = exk_profile_print(&rig->profile, NULL, 0);
    char *text = malloc(length + 1);
    if (text == NULL) {
        fprintf(stderr, "exk-loop: out of memory\n");
        return EXIT_IO;
    }
    exk_profile_print(&rig->profile, text, length + 1);
    fputs(text, stdout);
    free(text);
    return 0;
}

static int print_check(const loop_options *options, const exk_rig *rig)
{
    printf("%s: good: model %s, %zu holes, %" PRId64 " ticks of %g s (%.3f s)\n",
           options->profile_path, exk_kin_name(rig->profile.model), rig->n_holes,
           rig->plan.n_ticks, rig->plan.cfg.dt_s,
           (double)rig->plan.n_ticks * rig->plan.cfg.dt_s);
    return 0;
}

static int load_store(const loop_options *options, const exk_rig *rig, exk_store *store)
{
    char why[512];
    const exk_store_err err = exk_store_load(options->ilc_path, store, why, sizeof why);
    if (err == EXK_STORE_OK) {
        if (store->is_previous) {
            fprintf(stderr, "exk-loop: %s\n", why);
        }
        if (exk_store_match(store, rig->job_hash, rig->plan.cfg.dt_s, (size_t)rig->plan.n_ticks,
                            why, sizeof why) == EXK_STORE_OK) {
            return 0;
        }
        fprintf(stderr, "%s: %s\n", options->ilc_path, why);
        exk_store_free(store);
        return EXIT_INPUT;
    }
    fprintf(stderr, "%s\n", why);
    return err == EXK_STORE_IO ? EXIT_IO : EXIT_INPUT;
}

static int run_with_store(loop_options *options, exk_rig *rig)
{
    exk_store store;
    if (options->ilc_path == NULL) {
        options->run = options->run == 0 ? 1 : options->run;
        return loop_run(options, rig, NULL);
    }
    int code = load_store(options, rig, &store);
    if (code == 0) {
        options->run = options->run == 0 ? store.iteration : options->run;
        code = loop_run(options, rig, &store);
        exk_store_free(&store);
    }
    return code;
}

int main(int argc, char **argv)
{
    loop_options options;
    exk_rig rig;
    exk_standard_streams_hold();
    loop_options_parse(argc, argv, &options);
    int code = exk_rig_open(&rig, options.profile_path);
    if (code != 0) {
        return code;
    }
    if (options.print) {
        code = print_profile(&rig);
    } else if (options.check) {
        code = print_check(&options, &rig);
    } else {
        code = run_with_store(&options, &rig);
    }
    exk_rig_close(&rig);
    return exk_args_stdout_is_whole("exk-loop") ? code : EXIT_IO;
}
