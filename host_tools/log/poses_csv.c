#include "poses_csv.h"

#include <inttypes.h>

static const char header[] =
    "time_s,k,seq,phase,hole,hole_id,judged,sensor_ok,"
    "ref_x_m,ref_y_m,ref_z_m,ref_nx,ref_ny,ref_nz,"
    "est_x_m,est_y_m,est_z_m,est_nx,est_ny,est_nz,"
    "true_x_m,true_y_m,true_z_m,true_nx,true_ny,true_nz,"
    "alpha_ref_rad,beta_ref_rad,alpha_measured_rad,beta_measured_rad,"
    "alpha_true_rad,beta_true_rad,alpha_command_rad,beta_command_rad,"
    "alpha_feedback_rad,beta_feedback_rad,alpha_learned_rad,beta_learned_rad,"
    "h_m,l1_m,l2_m,l3_m,t4_rad,t5_rad,lateness_ns,step_ns\n";

int poses_csv_open(exk_out *out, const char *path, char *why, size_t why_size)
{
    const int code =
        exk_out_open(out, path, EXK_OUT_TEXT, "time_s,k,seq,phase,", why, why_size);
    if (code == 0) {
        fputs(header, out->file);
    }
    return code;
}

static void numbers(FILE *file, const double *values, int n, bool known)
{
    for (int i = 0; i < n; i++) {
        if (known) {
            fprintf(file, ",%.17g", values[i]);
        } else {
            fputc(',', file);
        }
    }
}

static void tool(FILE *file, const exk_tool *t, bool known)
{
    numbers(file, t->tip_m, 3, known);
    numbers(file, t->axis, 3, known);
}

void poses_csv_row(exk_out *out, const exk_wire_pose *pose)
{
    const exk_sample *s = &pose->sample;
    FILE *file = out->file;
    fprintf(file, "%.6f,%" PRId64 ",%" PRId64 ",%s,%" PRId32 ",%" PRId32 ",%d,%d",
            1e-6 * (double)s->time_us, s->k, pose->seq, exk_phase_name(s->phase), s->hole,
            s->hole_id, s->judged, s->sensor_ok);
    tool(file, &s->ref, true);
    tool(file, &s->est, true);
    tool(file, &s->real, s->has_true);
    numbers(file, s->r_rad, EXK_N_AXES, true);
    numbers(file, s->m_rad, EXK_N_AXES, true);
    numbers(file, s->theta_rad, EXK_N_AXES, s->has_true);
    numbers(file, s->q_rad, EXK_N_AXES, true);
    numbers(file, s->c_rad, EXK_N_AXES, true);
    numbers(file, s->u_rad, EXK_N_AXES, true);
    numbers(file, &s->h_m, 1, true);
    numbers(file, s->legs_m, EXK_N_LEGS, true);
    numbers(file, s->wrist_rad, EXK_N_WRIST, true);
    fprintf(file, ",%" PRId64 ",%" PRId64 "\n", pose->lateness_ns, pose->step_ns);
}
