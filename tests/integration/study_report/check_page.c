/* check-page FILE ID...: is this page whole and does it stand alone? Tags closed in order, ids unique,
 * references inside it answered, nothing fetched from elsewhere, every drawing named, every id there. */
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { DEPTH_MAX = 64, NAME_MAX_ = 32, IDS_MAX = 4096, ID_MAX = 64 };

typedef struct {
    char names[DEPTH_MAX][NAME_MAX_];
    int depth;
    char (*ids)[ID_MAX];
    size_t n_ids;
    char (*wanted)[ID_MAX]; /* what something refers to */
    size_t n_wanted;
    size_t n_drawings;
    size_t n_headless; /* th without scope */
    int n_faults;
} page;

static void fault(page *p, const char *what, const char *which)
{
    printf("%s: %s\n", what, which);
    p->n_faults++;
}

static bool is_one_of(const char *name, const char *const *list)
{
    for (; *list != NULL; list++) {
        if (strcmp(name, *list) == 0) {
            return true;
        }
    }
    return false;
}

/* The value of an attribute in a tag's text, "" when it has none. */
static void attribute(const char *tag, const char *key, char *out, size_t size)
{
    const size_t n = strlen(key);
    out[0] = '\0';
    for (const char *at = strstr(tag, key); at != NULL; at = strstr(at + 1, key)) {
        const bool whole = at > tag && strchr(" \t\n", at[-1]) != NULL && at[n] == '=';
        if (whole && (at[n + 1] == '"' || at[n + 1] == '\'')) {
            const char *from = at + n + 2;
            const size_t length = strcspn(from, at[n + 1] == '"' ? "\"" : "'");
            snprintf(out, size, "%.*s", (int)(length < size ? length : size - 1), from);
            return;
        }
    }
}

/* A longer text keeps its beginning: ids of ours are far shorter. */
static void remember(char (*list)[ID_MAX], size_t *n, const char *text)
{
    const size_t length = strlen(text) < ID_MAX ? strlen(text) : ID_MAX - 1;
    if (*n < IDS_MAX && length > 0) {
        memcpy(list[*n], text, length);
        list[(*n)++][length] = '\0';
    }
}

static bool has(char (*list)[ID_MAX], size_t n, const char *text)
{
    for (size_t i = 0; i < n; i++) {
        if (strcmp(list[i], text) == 0) {
            return true;
        }
    }
    return false;
}

/* aria-labelledby holds several. */
static void want_each(page *p, const char *list)
{
    char id[ID_MAX];
    while (*list != '\0') {
        const size_t n = strcspn(list, " ");
        snprintf(id, sizeof id, "%.*s", (int)(n < ID_MAX ? n : ID_MAX - 1), list);
        remember(p->wanted, &p->n_wanted, id);
        list += n + strspn(list + n, " ");
    }
}

static void check_attributes(page *p, const char *name, const char *tag)
{
    char value[512];
    attribute(tag, "id", value, sizeof value);
    if (has(p->ids, p->n_ids, value)) {
        fault(p, "id used twice", value);
    }
    remember(p->ids, &p->n_ids, value);
    attribute(tag, "href", value, sizeof value);
    if (value[0] == '#') {
        remember(p->wanted, &p->n_wanted, value + 1);
    } else if (value[0] != '\0') {
        fault(p, "leads out of the page", value);
    }
    attribute(tag, "src", value, sizeof value);
    if (value[0] != '\0') {
        fault(p, "is fetched", value);
    }
    attribute(tag, "aria-labelledby", value, sizeof value);
    want_each(p, value);
    attribute(tag, "role", value, sizeof value);
    if (strcmp(name, "svg") == 0 && strcmp(value, "img") == 0) {
        p->n_drawings++;
    }
    attribute(tag, "scope", value, sizeof value);
    if (strcmp(name, "th") == 0 && value[0] == '\0') {
        p->n_headless++;
    }
}

static void close_tag(page *p, const char *name)
{
    if (p->depth == 0 || strcmp(p->names[p->depth - 1], name) != 0) {
        fault(p, "closed out of order", name);
    } else {
        p->depth--;
    }
}

static void take_tag(page *p, const char *tag)
{
    static const char *const empty[] = {"meta", "link", "br", "hr", "img", "input", NULL};
    static const char *const barred[] = {"script", "link", "img", "iframe", "object", NULL};
    char name[NAME_MAX_];
    const bool closing = tag[0] == '/';
    const size_t n = strcspn(tag + closing, " \t\n/>");
    snprintf(name, sizeof name, "%.*s", (int)(n < NAME_MAX_ ? n : NAME_MAX_ - 1),
             tag + closing);
    if (tag[0] == '!') {
        return;
    }
    if (closing) {
        close_tag(p, name);
        return;
    }
    if (is_one_of(name, barred)) {
        fault(p, "does not belong here", name);
    }
    check_attributes(p, name, tag);
    if (tag[strlen(tag) - 1] != '/' && !is_one_of(name, empty) && p->depth < DEPTH_MAX) {
        snprintf(p->names[p->depth++], NAME_MAX_, "%s", name);
    }
}

static void take_text(page *p, char *text)
{
    for (char *at = strchr(text, '<'); at != NULL; at = strchr(at, '<')) {
        char *end = strchr(at, '>');
        if (end == NULL) {
            fault(p, "tag without an end", at);
            return;
        }
        *end = '\0';
        take_tag(p, at + 1);
        at = end + 1;
    }
}

static void check_whole(page *p, int n_ids, char **ids)
{
    if (p->depth != 0) {
        fault(p, "not closed", p->names[p->depth - 1]);
    }
    for (size_t i = 0; i < p->n_wanted; i++) {
        if (!has(p->ids, p->n_ids, p->wanted[i])) {
            fault(p, "refers to nothing", p->wanted[i]);
        }
    }
    for (int i = 0; i < n_ids; i++) {
        if (!has(p->ids, p->n_ids, ids[i])) {
            fault(p, "is not there", ids[i]);
        }
    }
    if (p->n_headless > 0) {
        fault(p, "has no scope", "th");
    }
}

static char *read_all(const char *path)
{
    FILE *file = fopen(path, "rb");
    char *text = NULL;
    size_t size = 0, n = 0;
    while (file != NULL && !feof(file)) {
        text = realloc(text, size + 65536 + 1);
        n = fread(text + size, 1, 65536, file);
        size += n;
        text[size] = '\0';
    }
    if (file != NULL) {
        fclose(file);
    }
    return text;
}

int main(int argc, char **argv)
{
    static const char *const foreign[] = {"http:", "https:", "@import", "url(", "rgb(", NULL};
    page p = {.depth = 0};
    char *text = argc > 1 ? read_all(argv[1]) : NULL;
    p.ids = calloc(IDS_MAX, sizeof *p.ids);
    p.wanted = calloc(IDS_MAX, sizeof *p.wanted);
    if (text == NULL || p.ids == NULL || p.wanted == NULL) {
        printf("no page\n");
        return 2;
    }
    for (int i = 0; foreign[i] != NULL; i++) {
        if (strstr(text, foreign[i]) != NULL) {
            fault(&p, "is in the page", foreign[i]);
        }
    }
    take_text(&p, text);
    check_whole(&p, argc - 2, argv + 2);
    printf("%zu drawings, %zu ids, %d faults\n", p.n_drawings, p.n_ids, p.n_faults);
    free(text);
    free(p.ids);
    free(p.wanted);
    return p.n_faults == 0 ? 0 : 1;
}
