/** Holds a JSON of exk-holes to its contract: check-json FILE.json FILE.csv
 *
 *  Keys and their types, figures that follow from the holes, the published ones, and the same
 *  numbers in the CSV. Differences of printing alone: 1e-9 mm, the last digit of the CSV.
 */
#include <jansson.h>
#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <string.h>

static int n_failed;

static void want(bool good, const char *what)
{
    if (!good) {
        fprintf(stderr, "check-json: not so: %s\n", what);
        n_failed++;
    }
}

static bool close_to(double a, double b)
{
    return fabs(a - b) <= 1e-9;
}

/* The keys come first, in this order, with these types ('s' string, 'r' real, 'i' integer, 'n'
 * number, 'b' true or false, 'a' array). */
static void want_keys(json_t *object, const char *const keys[], const char *types)
{
    void *at = json_object_iter(object);
    for (size_t i = 0; keys[i] != NULL; i++, at = json_object_iter_next(object, at)) {
        const char *found = at != NULL ? json_object_iter_key(at) : "nothing";
        const json_t *v = json_object_get(object, keys[i]);
        const bool type =
            (types[i] == 's' && json_is_string(v)) || (types[i] == 'i' && json_is_integer(v)) ||
            (types[i] == 'n' && json_is_number(v)) || (types[i] == 'b' && json_is_boolean(v)) ||
            (types[i] == 'a' && json_is_array(v));
        want(strcmp(found, keys[i]) == 0, keys[i]);
        want(type, keys[i]);
    }
}

static double number(const json_t *object, const char *key)
{
    return json_number_value(json_object_get(object, key));
}

typedef struct {
    size_t n_inside;
    double sum_mm;
    double max_mm;
} totals;

static void check_hole(json_t *hole, double tolerance_mm, totals *sum)
{
    static const char *const keys[] = {"id",    "x_mm",     "y_mm",   "dx_mm",
                                       "dy_mm", "error_mm", "inside", NULL};
    want_keys(hole, keys, "innnnnb");
    const double error_mm = number(hole, "error_mm");
    const bool inside = json_is_true(json_object_get(hole, "inside"));
    want(close_to(error_mm, hypot(number(hole, "dx_mm"), number(hole, "dy_mm"))),
         "error_mm is the length of dx_mm, dy_mm");
    want(inside == (error_mm <= tolerance_mm), "inside is error_mm <= tolerance_mm");
    sum->n_inside += inside ? 1 : 0;
    sum->sum_mm += error_mm;
    sum->max_mm = fmax(sum->max_mm, error_mm);
}

static void check_figures(json_t *root)
{
    json_t *holes = json_object_get(root, "holes");
    const size_t n = json_array_size(holes);
    totals sum = {0};
    for (size_t i = 0; i < n; i++) {
        check_hole(json_array_get(holes, i), number(root, "tolerance_mm"), &sum);
    }
    want((size_t)number(root, "n_holes") == n, "n_holes counts the holes");
    want((size_t)number(root, "n_inside") == sum.n_inside, "n_inside counts those inside");
    want(close_to(number(root, "correct_rate"), (double)sum.n_inside / (double)n),
         "correct_rate is n_inside / n_holes");
    want(close_to(number(root, "mean_mm"), sum.sum_mm / (double)n), "mean_mm");
    want(close_to(number(root, "max_mm"), sum.max_mm), "max_mm");
}

static void check_references(json_t *root)
{
    static const char *const names[] = {"Mazak", "Loxin", "Exechon"};
    static const double rate[] = {1.0, 0.8, 0.822};
    static const double mean_mm[] = {0.011417, 0.024466, 0.023614};
    json_t *refs = json_object_get(root, "references");
    want(json_array_size(refs) == 3, "three references");
    for (size_t i = 0; i < 3; i++) {
        const json_t *ref = json_array_get(refs, i);
        const char *name = json_string_value(json_object_get(ref, "name"));
        want(name != NULL && strcmp(name, names[i]) == 0, names[i]);
        want(close_to(number(ref, "correct_rate"), rate[i]), "rate of a reference");
        want(close_to(number(ref, "mean_mm"), mean_mm[i]), "mean of a reference");
    }
}

static void check_row(const char *row, const json_t *hole)
{
    int id = 0;
    int inside = 0;
    double x = 0.0;
    double y = 0.0;
    double z = 0.0;
    double dx = 0.0;
    double dy = 0.0;
    double error = 0.0;
    want(sscanf(row, "%d,%lf,%lf,%lf,%lf,%lf,%lf,%d,", &id, &x, &y, &z, &dx, &dy, &error,
                &inside) == 8,
         "a row of the CSV");
    want(id == (int)number(hole, "id"), "id in the CSV");
    want(close_to(x, number(hole, "x_mm")) && close_to(y, number(hole, "y_mm")),
         "target in the CSV");
    want(close_to(dx, number(hole, "dx_mm")) && close_to(dy, number(hole, "dy_mm")),
         "dx, dy in the CSV");
    want(close_to(error, number(hole, "error_mm")), "error in the CSV");
    want(inside == json_is_true(json_object_get(hole, "inside")), "inside in the CSV");
}

static void check_csv(json_t *root, const char *path)
{
    char row[512];
    FILE *csv = fopen(path, "r");
    json_t *holes = json_object_get(root, "holes");
    want(csv != NULL && fgets(row, sizeof row, csv) != NULL &&
             strcmp(row, "id,x_mm,y_mm,z_mm,dx_mm,dy_mm,error_mm,inside,tilt_mrad,k\n") == 0,
         "header of the CSV");
    size_t n = 0;
    while (csv != NULL && fgets(row, sizeof row, csv) != NULL) {
        check_row(row, json_array_get(holes, n++));
    }
    want(n == json_array_size(holes), "rows of the CSV");
    if (csv != NULL) {
        fclose(csv);
    }
}

int main(int argc, char **argv)
{
    static const char *const keys[] = {
        "profile",  "noise",        "judged_on", "tolerance_mm", "n_holes",
        "n_inside", "correct_rate", "mean_mm",   "max_mm",       "lost_samples",
        "holes",    "references",   NULL};
    json_error_t error;
    json_t *root = argc == 3 ? json_load_file(argv[1], JSON_REJECT_DUPLICATES, &error) : NULL;
    if (root == NULL) {
        fprintf(stderr, "check-json: %s\n", argc == 3 ? error.text : "wants JSON and CSV");
        return 2;
    }
    want_keys(root, keys, "sssniinnniaa");
    check_figures(root);
    check_references(root);
    check_csv(root, argv[2]);
    json_decref(root);
    return n_failed == 0 ? 0 : 1;
}
