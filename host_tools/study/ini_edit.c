#define _POSIX_C_SOURCE 200809L
#include "ini_edit.h"

#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "task.h"
#include "whole_file.h"

enum { WHY_SIZE = 512 };

/* "[name]" at the start of a line. */
static bool is_section(const char *line, const char *name)
{
    const size_t n = strlen(name);
    return line[0] == '[' && strncmp(line + 1, name, n) == 0 && line[1 + n] == ']';
}

/* "key =" with any blanks between. */
static bool is_key(const char *line, const char *key)
{
    const size_t n = strlen(key);
    const size_t blanks = strspn(line + (strncmp(line, key, n) == 0 ? n : 0), " \t");
    return strncmp(line, key, n) == 0 && line[n + blanks] == '=';
}

/* Copies line by line; returns how many values were set. */
static int copy(const char *text, const char *section, const char *key, const char *value,
                FILE *out)
{
    bool inside = false;
    int n_set = 0;
    while (*text != '\0') {
        const size_t n = strcspn(text, "\n") + (strchr(text, '\n') != NULL);
        if (text[0] == '[') {
            inside = is_section(text, section);
        }
        if (inside && is_key(text, key)) {
            fprintf(out, "%s = %s\n", key, value);
            n_set++;
        } else {
            fwrite(text, 1, n, out);
        }
        text += n;
    }
    return n_set;
}

static int replace(const char *path, const char *text, const char *section, const char *key,
                   const char *value)
{
    char why[WHY_SIZE] = "out of memory";
    char *changed = NULL;
    size_t size = 0;
    FILE *out = open_memstream(&changed, &size);
    const int n_set = out == NULL ? 0 : copy(text, section, key, value, out);
    bool good = out != NULL && fclose(out) == 0;
    if (good && n_set != 1) {
        fprintf(stderr, "exk-study: %s: [%s] %s stands there %d times, wanted once\n", path,
                section, key, n_set);
        free(changed);
        return STUDY_INPUT;
    }
    good = good && study_write_whole(path, (const uint8_t *)changed, size, why, sizeof why);
    if (!good) {
        fprintf(stderr, "exk-study: %s\n", why);
    }
    free(changed);
    return good ? STUDY_GOOD : STUDY_IO;
}

int study_ini_set(const char *path, const char *section, const char *key, const char *value)
{
    char why[WHY_SIZE];
    size_t n = 0;
    uint8_t *bytes = study_read_whole(path, &n, why, sizeof why);
    if (bytes == NULL) {
        fprintf(stderr, "exk-study: %s\n", why);
        return STUDY_IO;
    }
    bytes[n] = '\0'; /* read_whole leaves room for it */
    const int code = replace(path, (const char *)bytes, section, key, value);
    free(bytes);
    return code;
}
