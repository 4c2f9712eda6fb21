/** exk-doctor: is this machine ready for the bus and for real time? See options.c for its use. */
#include <stdio.h>

#include "bus_url.h"
#include "checks.h"
#include "exk/bus.h"
#include "exk/profile.h"
#include "exk/standard_streams.h"
#include "json_file.h"
#include "options.h"
#include "out_file.h"
#include "terminal.h"

static int write_json(const findings *all, const char *url, const char *path)
{
    char why[512];
    json_t *root = findings_json(all, url);
    const int code = exk_json_write(root, path, "url", why, sizeof why);
    json_decref(root);
    if (code != 0) {
        fprintf(stderr, "exk-doctor: %s\n", why);
    }
    return code;
}

int main(int argc, char **argv)
{
    doctor_options opt;
    findings all = {.n = 0};
    char url[EXK_PATH_MAX];
    char why[2 * EXK_PATH_MAX];
    int code = 0;
    exk_standard_streams_hold();
    doctor_options_parse(argc, argv, &opt);
    exk_bus_url(opt.url, url, sizeof url);
    if (!exk_bus_url_good(url, why, sizeof why)) {
        fprintf(stderr, "exk-doctor: %s\n", why);
        return 2;
    }
    check_bus(&all, url);
    check_host(&all);
    if (opt.json_path != NULL) {
        code = write_json(&all, url, opt.json_path);
    } else {
        findings_print(&all, stdout, exk_has_colour(stdout));
        code = exk_stdout_flush("exk-doctor");
    }
    if (code != 0) {
        return code;
    }
    return findings_worst(&all) == FINDING_FAIL ? 1 : 0;
}
