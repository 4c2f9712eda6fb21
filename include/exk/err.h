/** Error codes of the core.
 *
 *  Whatever can fail returns exk_err and writes its outputs only on EXK_OK. The core never prints
 *  and never exits; programs turn a code into a message and an exit code.
 */
#ifndef EXK_ERR_H
#define EXK_ERR_H

typedef enum {
    EXK_OK = 0,
    EXK_ERR_ARG,         /* an argument is not finite or not in its allowed range */
    EXK_ERR_SIZE,        /* a lent array is too short, or lengths do not match */
    EXK_ERR_UNREACHABLE, /* no pose of the mechanism meets the request */
    EXK_ERR_SINGULAR,    /* the pose is on, or too near, a singularity */
    EXK_ERR_NO_CONVERGE, /* an iteration met its bound before its tolerance */
    EXK_ERR_LIMIT,       /* reachable, but a leg, an angle or a rate leaves its limit */
    EXK_ERR_SENSOR,      /* too many bad sensor samples in a row */
    EXK_ERR_END,         /* a source has no further samples */
    EXK_ERR_OVERRUN,     /* too many deadlines missed in a row */
    EXK_ERR_SILENT,      /* the machine does not answer */
    EXK_ERR_ABORT,       /* a command asked to stop at once */
    EXK_ERR_COUNT
} exk_err;

/** Short lower-case name, for example "unreachable"; never NULL, "unknown" for other values. */
const char *exk_err_name(exk_err err);

#endif
