/* A CSV of holes of any bytes: refused with a reason, or finite targets and unit axes. */
#include <math.h>
#include <string.h>

#include "exk/job_csv.h"
#include "exk/vec3.h"
#include "fuzz.h"

enum { FAULTS = 8, HOLES = 64 };

static void good_holes(const exk_hole holes[], size_t n)
{
    PROMISE(n > 0 && n <= HOLES);
    for (size_t i = 0; i < n; i++) {
        PROMISE(exk_finite3(holes[i].target_m));
        PROMISE(fabs(exk_norm3(holes[i].axis) - 1.0) <= 1e-12);
        for (size_t j = 0; j < i; j++) {
            PROMISE(holes[i].id != holes[j].id);
        }
    }
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    exk_hole holes[HOLES];
    exk_fault faults[FAULTS];
    size_t n_holes = 0;
    size_t n_faults = 0;
    char *text = malloc(size + 1);
    PROMISE(text != NULL);
    if (size > 0) {
        memcpy(text, data, size);
    }
    text[size] = '\0';
    if (exk_job_csv_parse(text, 1.45, holes, HOLES, &n_holes, faults, FAULTS, &n_faults) ==
        EXK_OK) {
        PROMISE(n_faults == 0);
        good_holes(holes, n_holes);
    } else {
        PROMISE(n_faults > 0 && faults[0].message[0] != '\0');
    }
    free(text);
    return 0;
}
