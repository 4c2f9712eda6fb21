#include "read.h"

#include <ini.h>
#include <stdio.h>
#include <string.h>

#include "suggest.h"
#include "value.h"

enum { LABEL_SIZE = 96, HINT_SIZE = 256, FOUND_SIZE = 64 };

void exk_section_label(exk_section_id section, int instance, char out[EXK_SECTION_SIZE])
{
    const exk_section *of = exk_section_of(section);
    if (of->stem != NULL) {
        snprintf(out, EXK_SECTION_SIZE, "%s%d", of->stem, instance + 1);
    } else {
        snprintf(out, EXK_SECTION_SIZE, "%s", of->name);
    }
}

void *exk_key_field(exk_profile *profile, const exk_key *key, int instance)
{
    char *const whole = (char *)profile;
    const char *base = exk_key_base(profile, key->section, instance);
    return whole + (base - whole) + key->offset;
}

int exk_line_of_key(const exk_profile_reader *reading, exk_section_id section, int instance,
                    const char *name)
{
    const size_t i = exk_key_find(section, name);
    return i < exk_key_count() ? reading->key_line[instance][i] : 0;
}

/* N - 1 of "stem.N"; -1 for another name, EXK_INSTANCES_MAX for a number that is not allowed. */
static int instance_of(const exk_section *section, const char *name)
{
    const size_t stem = section->stem == NULL ? 0 : strlen(section->stem);
    if (stem == 0 || strncmp(name, section->stem, stem) != 0) {
        return -1;
    }
    const char digit = name[stem];
    const bool good = digit >= '1' && digit < '1' + EXK_INSTANCES_MAX && name[stem + 1] == '\0';
    return good ? digit - '1' : EXK_INSTANCES_MAX;
}

/* Finds the section of a header; EXK_IN_NOTHING when there is none of that name. */
static exk_section_id find_section(const char *name, int *instance)
{
    *instance = 0;
    for (int id = EXK_IN_NOTHING + 1; id < EXK_IN_COUNT; id++) {
        const exk_section *section = exk_section_of((exk_section_id)id);
        const int n = instance_of(section, name);
        if (n >= 0) {
            *instance = n < EXK_INSTANCES_MAX ? n : 0;
            return n < EXK_INSTANCES_MAX ? (exk_section_id)id : EXK_IN_NOTHING;
        }
        if (section->stem == NULL && strcmp(name, section->name) == 0) {
            return (exk_section_id)id;
        }
    }
    return EXK_IN_NOTHING;
}

static void count_instance(exk_profile_reader *r)
{
    exk_profile *p = &r->profile;
    const size_t n = (size_t)r->instance + 1;
    if (r->section == EXK_IN_DISTURBANCE && p->twin.n_disturbances < n) {
        p->twin.n_disturbances = n;
    }
    if (r->section == EXK_IN_FAULT && p->inject.n_faults < n) {
        p->inject.n_faults = n;
    }
}

static void enter_section(exk_profile_reader *r, const char *name)
{
    r->section = find_section(name, &r->instance);
    r->skips = r->section == EXK_IN_NOTHING;
    if (r->skips) {
        char hint[HINT_SIZE];
        exk_text text = exk_text_start(hint, sizeof(hint));
        exk_suggest_section(name, &text);
        exk_faults_add(&r->faults, r->line, "[%.40s]: %s", name, hint);
        return;
    }
    int *line = &r->section_line[r->instance][r->section];
    *line = *line == 0 ? r->line : *line;
    count_instance(r);
}

static void say_not_understood(exk_profile_reader *r)
{
    char found[FOUND_SIZE];
    exk_text text = exk_text_start(found, sizeof(found));
    exk_text_add_quoted(&text, r->start);
    exk_faults_add(&r->faults, r->line,
                   "not understood: found %s, allowed: [section], key = value, or a comment "
                   "after ; or #",
                   found);
}

static const char *skip_blanks(const char *text)
{
    while (*text == ' ' || *text == '\t') {
        text++;
    }
    return text;
}

/* A header is the whole line but for a comment. */
static void read_header(exk_profile_reader *r, const char *line)
{
    const char *end = strchr(line, ']');
    const char *rest = end == NULL ? "?" : skip_blanks(end + 1);
    if (strchr(";#\r\n", *rest) == NULL) {
        say_not_understood(r);
        r->section = EXK_IN_NOTHING;
        r->skips = true;
        return;
    }
    char name[EXK_LINE_START];
    const size_t length = (size_t)(end - line) - 1;
    snprintf(name, sizeof(name), "%.*s", (int)length, line + 1);
    enter_section(r, name);
}

static void say_too_long(exk_profile_reader *r, size_t length, size_t longest)
{
    exk_faults_add(&r->faults, r->line,
                   "line too long: found %zu characters, allowed %zu; shorten it or move the "
                   "comment to a line of its own",
                   length, longest);
}

/* Hands over the next line without the blanks before it, which inih would take for a continuation
 * of the line above. The room that inih lends is the longest line it can take. */
static char *next_line(char *out, int room, void *stream)
{
    exk_profile_reader *r = stream;
    if (r->expects_value) {
        say_not_understood(r);
    }
    r->expects_value = false;
    if (*r->next == '\0') {
        return NULL;
    }
    const char *start = skip_blanks(r->next);
    const size_t length = strcspn(start, "\n");
    const size_t longest = (size_t)room - 2;
    r->next = start + length + (start[length] == '\n' ? 1 : 0);
    r->line++;
    snprintf(r->start, sizeof(r->start), "%.*s", (int)strcspn(start, "\r\n"), start);
    snprintf(out, (size_t)room, "%.*s\n", length > longest ? 0 : (int)length, start);
    if (length > longest) {
        say_too_long(r, length, longest);
    } else if (out[0] == '[') {
        read_header(r, out);
    } else {
        r->expects_value = strchr(";#\r\n", out[0]) == NULL;
    }
    return out;
}

static void say_unknown_key(exk_profile_reader *r, const char *name)
{
    char label[EXK_SECTION_SIZE];
    char hint[HINT_SIZE];
    exk_text text = exk_text_start(hint, sizeof(hint));
    exk_section_label(r->section, r->instance, label);
    exk_suggest_key(r->section, name, &text);
    exk_faults_add(&r->faults, r->line, "[%s] %.40s: %s", label, name, hint);
    r->has_unknown[r->instance] |= r->section == EXK_IN_DISTURBANCE;
}

static void read_value(exk_profile_reader *r, size_t i, const char *value)
{
    const exk_key *key = exk_key_at(i);
    char section[EXK_SECTION_SIZE];
    char label[LABEL_SIZE];
    int *line = &r->key_line[r->instance][i];
    exk_section_label(r->section, r->instance, section);
    snprintf(label, sizeof(label), "[%s] %s", section, key->name);
    if (*line != 0) {
        exk_faults_add(&r->faults, r->line, "%s: given twice: first in line %d; keep one",
                       label, *line);
        return;
    }
    *line = r->line;
    void *field = exk_key_field(&r->profile, key, r->instance);
    r->refused[r->instance][i] = !exk_value_read(key, value, field, &r->faults, r->line, label);
}

static int on_value(void *user, const char *section, const char *name, const char *value)
{
    exk_profile_reader *r = user;
    (void)section; /* cut to 49 characters by inih; ours is whole */
    if (name[0] == '\0') {
        return 1; /* no name: the line still expects one and will be named */
    }
    r->expects_value = false;
    if (r->skips) {
        return 1;
    }
    if (r->section == EXK_IN_NOTHING) {
        exk_faults_add(&r->faults, r->line,
                       "%.40s: stands before the first section; put it under its [section]",
                       name);
        return 1;
    }
    const size_t i = exk_key_find(r->section, name);
    if (i < exk_key_count()) {
        read_value(r, i, value);
    } else {
        say_unknown_key(r, name);
    }
    return 1;
}

void exk_read_profile(exk_profile_reader *reading, const char *text)
{
    static const char byte_order_mark[] = "\xef\xbb\xbf";
    const size_t n = sizeof(byte_order_mark) - 1;
    reading->next = strncmp(text, byte_order_mark, n) == 0 ? text + n : text;
    ini_parse_stream(next_line, reading, on_value, reading);
}
