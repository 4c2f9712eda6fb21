#include <stddef.h>
#include <stdio.h>
#include <string.h>

#include "check_parts.h"
#include "exk/units.h"

/* The two keys of a published ratio (geometry.h). */
typedef struct {
    const char *start; /* of the fault's name */
    const char *over;
    const char *under;
    size_t over_at;
    size_t under_at;
} ratio_keys;

#define LENGTH(field) offsetof(exk_geometry, field)
static const ratio_keys ratios[] = {
    {"p1 ", "d1_mm", "d5_mm", LENGTH(d1_m), LENGTH(d5_m)},
    {"p2 ", "d2_mm", "d1_mm", LENGTH(d2_m), LENGTH(d1_m)},
    {"p3 ", "d3_mm", "d1_mm", LENGTH(d3_m), LENGTH(d1_m)},
    {"p4 ", "d4_mm", "d3_mm", LENGTH(d4_m), LENGTH(d3_m)},
};

static double length_mm(const exk_geometry *geo, size_t at)
{
    double value_m;
    memcpy(&value_m, (const char *)geo + at, sizeof(value_m));
    return value_m * EXK_MM_PER_M;
}

/* "0.5 to 1", or "0.75" where one value alone is allowed. */
typedef struct {
    char text[2 * EXK_NUMBER_SIZE + 4];
} shown_span;

static shown_span show_span(double min, double max)
{
    shown_span span;
    const bool one = strcmp(exk_check_show(min).text, exk_check_show(max).text) == 0;
    snprintf(span.text, sizeof(span.text), "%s%s%s", exk_check_show(min).text,
             one ? "" : " to ", one ? "" : exk_check_show(max).text);
    return span;
}

/* Blames the key that the file gives, the upper one where it gives both or none, and says which
 * lengths of it would do. */
static void say_ratio(exk_profile_reader *r, const ratio_keys *keys,
                      const exk_geometry_fault *fault)
{
    const exk_geometry *geo = &r->profile.geometry;
    const double over = length_mm(geo, keys->over_at);
    const double under = length_mm(geo, keys->under_at);
    const bool over_given = exk_check_given(r, EXK_IN_MACHINE, 0, keys->over);
    const bool upper = over_given || !exk_check_given(r, EXK_IN_MACHINE, 0, keys->under);
    const char *name = upper ? keys->over : keys->under;
    const double length = upper ? over / fault->value : under * fault->value;
    const double least = upper ? length * fault->min : length / fault->max;
    const double most = upper ? length * fault->max : length / fault->min;
    exk_faults_add(&r->faults, exk_check_line(r, EXK_IN_MACHINE, 0, name),
                   "[machine] %s: ratio %s out of range: found %s, allowed: %s (%s = %s, %s = "
                   "%s); choose %s %s",
                   name, fault->name, exk_check_show(fault->value).text,
                   show_span(fault->min, fault->max).text, keys->over,
                   exk_check_show(over).text, keys->under, exk_check_show(under).text, name,
                   show_span(least, most).text);
}

static const ratio_keys *find_ratio(const char *fault_name)
{
    for (size_t i = 0; i < sizeof(ratios) / sizeof(ratios[0]); i++) {
        if (strncmp(fault_name, ratios[i].start, strlen(ratios[i].start)) == 0) {
            return &ratios[i];
        }
    }
    return NULL;
}

void exk_check_geometry(exk_profile_reader *r)
{
    exk_geometry_fault faults[EXK_GEOMETRY_FAULTS_MAX];
    const size_t n = exk_geometry_faults(&r->profile.geometry, faults, EXK_GEOMETRY_FAULTS_MAX);
    for (size_t i = 0; i < n; i++) {
        const ratio_keys *keys = find_ratio(faults[i].name);
        if (keys != NULL && (exk_check_refused(r, EXK_IN_MACHINE, keys->over) ||
                             exk_check_refused(r, EXK_IN_MACHINE, keys->under))) {
            continue; /* said already */
        }
        if (keys != NULL) {
            say_ratio(r, keys, &faults[i]);
        } else { /* the table has the same bounds, so that only rounding can lead here */
            exk_faults_add(&r->faults, r->section_line[0][EXK_IN_MACHINE],
                           "[machine] %s: out of range", faults[i].name);
        }
    }
}
