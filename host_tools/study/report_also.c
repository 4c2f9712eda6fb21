#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "compare_result.h"
#include "report.h"

/* A JSON file that has the list named; *root is NULL then and after a failure. */
static int load(const char *path, const char *list, const char *command, json_t **root)
{
    json_error_t error;
    *root = json_load_file(path, 0, &error);
    if (*root == NULL) {
        fprintf(stderr, "exk-study: %s: line %d: %s\n", path, error.line, error.text);
        return error.line < 0 ? STUDY_IO : STUDY_INPUT;
    }
    if (!json_is_array(json_object_get(*root, list))) {
        fprintf(
            stderr,
            "exk-study: %s: has no list \"%s\": give a file that exk-study %s --json wrote\n",
            path, list, command);
        return STUDY_INPUT;
    }
    return STUDY_GOOD;
}

static int run_compare(const char *profiles, const study_work *work, json_t **root)
{
    study_work here = *work;
    study_sums totals = {.n = 0};
    exk_rig rig;
    study_compare *compare = calloc(1, sizeof *compare);
    here.alone = true;
    int code = compare == NULL ? STUDY_IO : study_compare_init(compare, profiles);
    if (code == STUDY_GOOD) {
        code = study_compare_run(compare, &here, &totals, &rig);
    }
    if (code == STUDY_GOOD) {
        *root = study_compare_json(compare, &rig, totals.tallies, here.n_trials);
        exk_rig_close(&rig);
    }
    study_sums_close(&totals);
    free(compare);
    return code;
}

int study_also_open(study_also *also, const char *compare_path, const char *sensitivity_path)
{
    *also = (study_also){.compare = NULL};
    int code = STUDY_GOOD;
    if (compare_path != NULL) {
        code = load(compare_path, "controllers", "compare", &also->compare);
    }
    if (code == STUDY_GOOD && sensitivity_path != NULL) {
        code = load(sensitivity_path, "sensitivity", "sensitivity", &also->sensitivity);
    }
    return code;
}

int study_also_run(study_also *also, const char *profiles, const study_work *work)
{
    return also->compare != NULL ? STUDY_GOOD : run_compare(profiles, work, &also->compare);
}

void study_also_close(study_also *also)
{
    json_decref(also->compare);
    json_decref(also->sensitivity);
    *also = (study_also){.compare = NULL};
}
