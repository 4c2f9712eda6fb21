#include "capture_file.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "exk/capture_file.h"

const double loop_capture_s = 2.0;

/* run.lcm -> run.fault.lcm */
static char *name_beside(const char *record)
{
    static const char ending[] = ".lcm";
    static const char added[] = ".fault.lcm";
    const size_t length = strlen(record);
    const size_t tail = sizeof ending - 1;
    const bool ends = length > tail && strcmp(record + length - tail, ending) == 0;
    const size_t stem = ends ? length - tail : length;
    char *name = malloc(stem + sizeof added);
    if (name != NULL) {
        memcpy(name, record, stem);
        memcpy(name + stem, added, sizeof added);
    }
    return name;
}

static bool write_to(const char *path, const loop_ticks *t, const exk_run_info *info)
{
    char why[512];
    const exk_capture *capture = &t->rig->capture;
    if (!exk_capture_file_write(path, info, capture, &t->record, why, sizeof why)) {
        fprintf(stderr, "exk-loop: the samples before the fault are not kept: %s\n", why);
        return false;
    }
    fprintf(stderr, "exk-loop: the %zu samples before the fault, at full rate: %s\n",
            exk_capture_count(capture), path);
    return true;
}

bool loop_capture_write(const loop_ticks *t, const exk_run_info *info)
{
    const exk_capture *capture = &t->rig->capture;
    if (info->record_path == NULL || !capture->frozen || exk_capture_count(capture) == 0) {
        return true;
    }
    char *path = name_beside(info->record_path);
    const size_t length = exk_profile_print(info->profile, NULL, 0);
    char *text = malloc(length + 1);
    bool good = path != NULL && text != NULL;
    if (good) {
        exk_run_info copy = *info;
        exk_profile_print(info->profile, text, length + 1);
        copy.profile_text = text;
        good = write_to(path, t, &copy);
    }
    free(text);
    free(path);
    return good;
}
