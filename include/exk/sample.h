/** Everything one step of the loop knows; telemetry, a CSV writer and a test see the same value.
 *
 *  Units   metres, radians, base frame.  Memory  a plain value, no pointer.
 */
#ifndef EXK_SAMPLE_H
#define EXK_SAMPLE_H

#include <stdbool.h>
#include <stdint.h>

#include "exk/axes.h"
#include "exk/plan.h"

typedef struct {
    int64_t k;
    int64_t time_us; /* k * dt, rounded */
    exk_phase phase;
    int32_t hole;    /* index in drilling order */
    int32_t hole_id; /* id in the job */
    bool judged;
    bool sensor_ok;
    bool has_true;
    exk_tool ref;
    exk_tool est;  /* FK(m) */
    exk_tool real; /* FK(theta); valid when has_true */
    double r_rad[EXK_N_AXES];
    double m_rad[EXK_N_AXES];
    double theta_rad[EXK_N_AXES];
    double q_rad[EXK_N_AXES];
    double c_rad[EXK_N_AXES];
    double u_rad[EXK_N_AXES];
    double h_m;
    double legs_m[EXK_N_LEGS];
    double wrist_rad[EXK_N_WRIST];
} exk_sample;

#endif
