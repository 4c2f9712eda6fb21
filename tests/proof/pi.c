/* PID: whatever the gains and errors are, init refuses, or the output is finite for ever, and within c_max. */
#include "any.h"
#include "exk/pid.h"

static const double c_max_rad =
    0.1; /* where the limit is asked for: Eva knows ranges, not relations */

static exk_pid_config any_gains(double limit_rad)
{
    return (exk_pid_config){.kp = any_bits(),
                            .ki = any_bits(),
                            .kd = any_bits(),
                            .d_filter_s = any_bits(),
                            .c_max_rad = limit_rad,
                            .dt_s = any_bits()};
}

static void use(exk_pid *pid)
{
    const int what = any_of(3);
    if (what == 0) {
        exk_pid_preset(pid, any_bits(), any_bits());
    } else if (what == 1) {
        exk_pid_rejoin(pid, any_bits());
    } else {
        exk_pid_reset(pid);
    }
}

int main(void)
{
    exk_pid any, limited;
    const exk_pid_config any_cfg = any_gains(any_bits());
    const exk_pid_config limited_cfg = any_gains(c_max_rad);
    if (exk_pid_init(&any, &any_cfg) == EXK_OK) {
        while (any_of(2) != 0) {
            const double c = exk_pid_step(&any, any_bits());
            /*@ assert finite: \is_finite(c); */
            use(&any);
        }
    }
    if (exk_pid_init(&limited, &limited_cfg) == EXK_OK) {
        while (any_of(2) != 0) {
            const double c = exk_pid_step(&limited, any_bits());
            /*@ assert limited: -c_max_rad <= c <= c_max_rad; */
            use(&limited);
        }
    }
    return 0;
}
