/** One line of exk-doctor: what was looked at, what was found, what to do. */
#ifndef EXK_DOCTOR_FINDING_H
#define EXK_DOCTOR_FINDING_H

#include <jansson.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

typedef enum { FINDING_OK, FINDING_WARN, FINDING_FAIL } finding_state;

typedef struct {
    const char *name;
    finding_state state;
    char found[256];
    char remedy[512]; /* empty when all is well */
} finding;

enum { FINDINGS_MAX = 16 };

typedef struct {
    finding list[FINDINGS_MAX];
    size_t n;
} findings;

/** Adds a line that is OK and returns it. */
finding *finding_add(findings *all, const char *name);

/** Fills in; remedy may be NULL. */
void finding_set(finding *f, finding_state state, const char *remedy);

finding_state findings_worst(const findings *all);
void findings_print(const findings *all, FILE *out, bool colour);

/** {"url", "state", "checks": [{"name", "state", "found", "remedy"}]}; the caller's to release. */
json_t *findings_json(const findings *all, const char *url);

#endif
