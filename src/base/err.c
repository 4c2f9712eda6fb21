#include "exk/err.h"

#include <stddef.h>

static const char *const names[EXK_ERR_COUNT] = {
    [EXK_OK] = "ok",
    [EXK_ERR_ARG] = "bad argument",
    [EXK_ERR_SIZE] = "wrong size",
    [EXK_ERR_UNREACHABLE] = "unreachable",
    [EXK_ERR_SINGULAR] = "singular",
    [EXK_ERR_NO_CONVERGE] = "no convergence",
    [EXK_ERR_LIMIT] = "beyond limit",
    [EXK_ERR_SENSOR] = "sensor fault",
    [EXK_ERR_END] = "end of data",
    [EXK_ERR_OVERRUN] = "deadlines missed",
    [EXK_ERR_SILENT] = "no answer from the machine",
    [EXK_ERR_ABORT] = "aborted",
};

const char *exk_err_name(exk_err err)
{
    if ((unsigned)err >= EXK_ERR_COUNT || names[err] == NULL) {
        return "unknown";
    }
    return names[err];
}
