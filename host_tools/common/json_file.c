#include "json_file.h"

#include <math.h>
#include <stdio.h>

#include "out_file.h"

json_t *exk_json_real(double value)
{
    return isfinite(value) ? json_real(value) : json_null();
}

int exk_json_write(const json_t *root, const char *path, const char *first_key, char *why,
                   size_t why_size)
{
    char begins[128];
    exk_out out;
    snprintf(begins, sizeof begins, "{\n  \"%s\":", first_key);
    const int refused = exk_out_open(&out, path, EXK_OUT_TEXT, begins, why, why_size);
    if (refused != 0) {
        return refused;
    }
    if (json_dumpf(root, out.file, JSON_INDENT(2) | JSON_REAL_PRECISION(12)) != 0) {
        exk_out_abort(&out);
        snprintf(why, why_size, "%s: the JSON text could not be written", path);
        return 3;
    }
    fputc('\n', out.file);
    return exk_out_commit(&out, why, why_size);
}
