#include "files.h"

#include <inttypes.h>
#include <stdio.h>

#include "exk/units.h"
#include "json_file.h"
#include "out_file.h"

#define CSV_HEADER "id,x_mm,y_mm,z_mm,dx_mm,dy_mm,error_mm,inside,tilt_mrad,k\n"

static json_t *json_mm(double metres)
{
    return exk_json_real(EXK_MM_PER_M * metres);
}

/* A figure over the drilled holes: null when there is none. */
static json_t *json_mm_drilled(const hole_report *report, double metres)
{
    return report->accuracy.n_drilled > 0 ? json_mm(metres) : json_null();
}

static json_t *json_hole(const exk_hole *hole, const exk_hole_result *r)
{
    json_t *out = json_object();
    json_object_set_new(out, "id", json_integer(hole->id));
    json_object_set_new(out, "x_mm", json_mm(hole->target_m[0]));
    json_object_set_new(out, "y_mm", json_mm(hole->target_m[1]));
    json_object_set_new(out, "dx_mm", r->drilled ? json_mm(r->dx_m) : json_null());
    json_object_set_new(out, "dy_mm", r->drilled ? json_mm(r->dy_m) : json_null());
    json_object_set_new(out, "error_mm", r->drilled ? json_mm(r->radial_m) : json_null());
    json_object_set_new(out, "inside", json_boolean(r->inside));
    json_object_set_new(out, "z_mm", json_mm(hole->target_m[2]));
    json_object_set_new(out, "tilt_mrad",
                        r->drilled ? exk_json_real(1e3 * r->tilt_rad) : json_null());
    json_object_set_new(out, "k", r->drilled ? json_integer(r->k) : json_null());
    return out;
}

static json_t *json_holes(const hole_report *report)
{
    json_t *out = json_array();
    for (size_t i = 0; i < report->n_holes; i++) {
        json_array_append_new(out, json_hole(&report->log->holes[i], &report->results[i]));
    }
    return out;
}

static json_t *json_references(void)
{
    size_t n = 0;
    const exk_reference *refs = exk_references(&n);
    json_t *out = json_array();
    for (size_t i = 0; i < n; i++) {
        json_t *ref = json_object();
        json_object_set_new(ref, "name", json_string(refs[i].name));
        json_object_set_new(ref, "kind", json_string(refs[i].kind));
        json_object_set_new(ref, "n_holes",
                            refs[i].n_holes > 0 ? json_integer((json_int_t)refs[i].n_holes)
                                                : json_null());
        json_object_set_new(ref, "correct_rate", exk_json_real(refs[i].correct_rate));
        json_object_set_new(ref, "mean_mm", json_mm(refs[i].mean_m));
        json_object_set_new(ref, "source", json_string(refs[i].source));
        json_array_append_new(out, ref);
    }
    return out;
}

static json_t *json_unreached(const hole_report *report)
{
    json_t *out = json_array();
    for (size_t i = 0; i < report->n_holes; i++) {
        if (!report->results[i].drilled) {
            json_array_append_new(out, json_integer(report->log->holes[i].id));
        }
    }
    return out;
}

/* The keys that others rely on, in the order they were promised. */
static void set_contract(json_t *out, const hole_report *report)
{
    const exk_accuracy *a = &report->accuracy;
    json_object_set_new(out, "profile", json_string(report->log->profile_name));
    json_object_set_new(out, "noise", json_string(report->noise));
    json_object_set_new(out, "judged_on", json_string(report->on_true ? "true" : "estimated"));
    json_object_set_new(out, "tolerance_mm", json_mm(report->tolerance_m));
    json_object_set_new(out, "n_holes", json_integer((json_int_t)report->n_holes));
    json_object_set_new(out, "n_inside", json_integer((json_int_t)a->n_inside));
    json_object_set_new(out, "correct_rate", exk_json_real(report->correct_rate));
    json_object_set_new(out, "mean_mm", json_mm_drilled(report, a->mean_m));
    json_object_set_new(out, "max_mm", json_mm_drilled(report, a->max_m));
    json_object_set_new(out, "lost_samples", json_integer(report->n_lost));
    json_object_set_new(out, "holes", json_holes(report));
    json_object_set_new(out, "references", json_references());
}

static void set_run(json_t *out, const hole_report *report)
{
    const exk_run_log *log = report->log;
    json_object_set_new(out, "evidence", json_boolean(report->n_lost == 0));
    json_object_set_new(out, "complete", json_boolean(log->ended && !log->truncated));
    json_object_set_new(out, "n_samples", json_integer((json_int_t)log->n_samples));
    json_object_set_new(out, "skipped_ticks", json_integer(log->n_skipped_k));
    json_object_set_new(out, "run", json_integer(log->run));
    json_object_set_new(out, "series", json_integer(log->series));
    json_object_set_new(out, "seed", json_integer((json_int_t)log->seed));
}

static void set_statistics(json_t *out, const hole_report *report)
{
    const exk_accuracy *a = &report->accuracy;
    const exk_hole *worst = a->worst >= 0 ? &report->log->holes[a->worst] : NULL;
    json_object_set_new(out, "n_drilled", json_integer((json_int_t)a->n_drilled));
    json_object_set_new(out, "not_reached", json_unreached(report));
    json_object_set_new(out, "worst_id", worst != NULL ? json_integer(worst->id) : json_null());
    json_object_set_new(out, "wilson95",
                        json_pack("[o, o]", exk_json_real(report->wilson.low),
                                  exk_json_real(report->wilson.high)));
    json_object_set_new(out, "true_position_mean_mm",
                        json_mm_drilled(report, exk_true_position(a->mean_m)));
    json_object_set_new(out, "true_position_max_mm",
                        json_mm_drilled(report, exk_true_position(a->max_m)));
    json_object_set_new(out, "rayleigh_sigma_mm", json_mm(report->sigma_m));
    json_object_set_new(out, "expected_inside", exk_json_real(report->expected_inside));
    json_object_set_new(out, "ppk", exk_json_real(report->ppk));
    json_object_set_new(out, "ap_mm", json_mm(report->pose.ap));
    json_object_set_new(out, "rp_mm", json_mm(report->pose.rp));
    json_object_set_new(out, "max_tilt_mrad", exk_json_real(1e3 * report->max_tilt_rad));
    json_object_set_new(out, "rms_path_mm", json_mm(a->rms_path_m));
    json_object_set_new(out, "last_point_mm", json_mm(a->last_point_m));
}

int hole_json_write(const hole_report *report, const char *path, char *why, size_t why_size)
{
    json_t *out = json_object();
    set_contract(out, report);
    set_run(out, report);
    set_statistics(out, report);
    const int code = exk_json_write(out, path, "profile", why, why_size);
    json_decref(out);
    return code;
}

/* Nine decimals of a millimetre: finer than any figure here means. */
static void write_row(FILE *csv, const exk_hole *hole, const exk_hole_result *r)
{
    fprintf(csv, "%" PRId32 ",%.9f,%.9f,%.9f,", hole->id, EXK_MM_PER_M * hole->target_m[0],
            EXK_MM_PER_M * hole->target_m[1], EXK_MM_PER_M * hole->target_m[2]);
    if (!r->drilled) {
        fputs(",,,0,,\n", csv);
        return;
    }
    fprintf(csv, "%.9f,%.9f,%.9f,%d,%.9f,%" PRId64 "\n", EXK_MM_PER_M * r->dx_m,
            EXK_MM_PER_M * r->dy_m, EXK_MM_PER_M * r->radial_m, r->inside ? 1 : 0,
            1e3 * r->tilt_rad, r->k);
}

int hole_csv_write(const hole_report *report, const char *path, char *why, size_t why_size)
{
    exk_out out;
    const int refused = exk_out_open(&out, path, EXK_OUT_TEXT, CSV_HEADER, why, why_size);
    if (refused != 0) {
        return refused;
    }
    fputs(CSV_HEADER, out.file);
    for (size_t i = 0; i < report->n_holes; i++) {
        write_row(out.file, &report->log->holes[i], &report->results[i]);
    }
    return exk_out_commit(&out, why, why_size);
}
