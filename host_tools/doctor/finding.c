#include "finding.h"

static const char *const names[] = {
    [FINDING_OK] = "ok", [FINDING_WARN] = "warn", [FINDING_FAIL] = "fail"};
static const char *const colours[] = {
    [FINDING_OK] = "\033[32m", [FINDING_WARN] = "\033[33m", [FINDING_FAIL] = "\033[31m"};

finding *finding_add(findings *all, const char *name)
{
    finding *f = &all->list[all->n < FINDINGS_MAX - 1 ? all->n++ : all->n];
    *f = (finding){.name = name, .state = FINDING_OK};
    return f;
}

void finding_set(finding *f, finding_state state, const char *remedy)
{
    f->state = state;
    snprintf(f->remedy, sizeof f->remedy, "%s", remedy != NULL ? remedy : "");
}

finding_state findings_worst(const findings *all)
{
    finding_state worst = FINDING_OK;
    for (size_t i = 0; i < all->n; i++) {
        worst = all->list[i].state > worst ? all->list[i].state : worst;
    }
    return worst;
}

void findings_print(const findings *all, FILE *out, bool colour)
{
    for (size_t i = 0; i < all->n; i++) {
        const finding *f = &all->list[i];
        fprintf(out, "%s%-4s%s  %-10s %s\n", colour ? colours[f->state] : "", names[f->state],
                colour ? "\033[0m" : "", f->name, f->found);
        if (f->remedy[0] != '\0') {
            fprintf(out, "      %-10s -> %s\n", "", f->remedy);
        }
    }
}

json_t *findings_json(const findings *all, const char *url)
{
    json_t *root = json_object();
    json_t *checks = json_array();
    json_object_set_new(root, "url", json_string(url));
    json_object_set_new(root, "state", json_string(names[findings_worst(all)]));
    for (size_t i = 0; i < all->n; i++) {
        const finding *f = &all->list[i];
        json_array_append_new(checks, json_pack("{s:s,s:s,s:s,s:s}", "name", f->name, "state",
                                                names[f->state], "found", f->found, "remedy",
                                                f->remedy));
    }
    json_object_set_new(root, "checks", checks);
    return root;
}
