#include "exk/stats.h"

#define STUDY                                                                                  \
    "Using Kinematic Models to Improve the Performance of Wing Root Drilling Processes"

/* Published figures of the study, radial error, circle of 0.03 mm. The study prints no number of
 * holes for the two measured machines. */
static const exk_reference table[] = {
    {"Mazak", "measured machine", 0, 0, 1.0, 0.011417e-3, STUDY},
    {"Loxin", "measured machine", 0, 0, 0.800, 0.024466e-3, STUDY},
    {"Exechon", "published model", 45, 37, 0.822, 0.023614e-3, STUDY},
};

const exk_reference *exk_references(size_t *n)
{
    *n = sizeof table / sizeof table[0];
    return table;
}
