#define _POSIX_C_SOURCE 200809L

#include "profile_file.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { GOOD = 0, BAD_INPUT = 2, BAD_FILE = 3, FAULTS_MAX = 64 };

static void print_faults(const char *path, const exk_fault *faults, size_t n_faults)
{
    for (size_t i = 0; i < n_faults && i < FAULTS_MAX; i++) {
        if (faults[i].line > 0) {
            fprintf(stderr, "%s:%d: %s\n", path, faults[i].line, faults[i].message);
        } else {
            fprintf(stderr, "%s: %s\n", path, faults[i].message);
        }
    }
    if (n_faults > FAULTS_MAX) {
        fprintf(stderr, "%s: and %zu more\n", path, n_faults - FAULTS_MAX);
    }
}

static int parse(const char *path, const char *text, exk_profile *profile)
{
    static exk_fault faults[FAULTS_MAX];
    size_t n_faults = 0;
    if (exk_profile_parse(text, profile, faults, FAULTS_MAX, &n_faults) == EXK_OK) {
        return GOOD;
    }
    print_faults(path, faults, n_faults);
    return BAD_INPUT;
}

/* getdelim up to a zero byte takes a whole text at once; a file that holds one is no text. */
static int read_text(const char *path, FILE *file, char **text)
{
    size_t capacity = 0;
    errno = 0;
    const ssize_t n = getdelim(text, &capacity, '\0', file);
    if (ferror(file)) {
        fprintf(stderr, "%s: cannot be read: %s\n", path, strerror(errno));
        return BAD_FILE;
    }
    if (n > 0 && !feof(file)) {
        fprintf(stderr, "%s: not a text file: a zero byte stands in it\n", path);
        return BAD_INPUT;
    }
    return GOOD;
}

int exk_profile_file_read(const char *path, exk_profile *profile)
{
    FILE *file = fopen(path, "r");
    if (file == NULL) {
        fprintf(stderr, "%s: cannot be opened: %s\n", path, strerror(errno));
        return BAD_FILE;
    }
    char *text = NULL;
    int rc = read_text(path, file, &text);
    if (rc == GOOD) {
        rc = parse(path, text != NULL ? text : "", profile);
    }
    free(text);
    fclose(file);
    return rc;
}
