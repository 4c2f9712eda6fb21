#define _POSIX_C_SOURCE 200809L
#include "exk/input.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const size_t largest_bytes = (size_t)16 << 20;

/* Reads at most size bytes and a NUL; the bytes read, or size + 1 when there were more. */
static size_t fill(FILE *file, char *text, size_t size)
{
    const size_t n = fread(text, 1, size, file);
    text[n] = '\0';
    return n == size && fgetc(file) != EOF ? size + 1 : n;
}

static int judge(const char *path, FILE *file, const char *text, size_t n)
{
    if (ferror(file)) {
        fprintf(stderr, "%s: cannot be read: %s\n", path, strerror(errno));
        return EXK_INPUT_UNREADABLE;
    }
    if (n > largest_bytes) {
        fprintf(stderr, "%s: larger than 16 MiB: not a text of ours\n", path);
        return EXK_INPUT_BAD;
    }
    if (memchr(text, '\0', n) != NULL) {
        fprintf(stderr, "%s: not a text file: a zero byte stands in it\n", path);
        return EXK_INPUT_BAD;
    }
    return 0;
}

static int read_stream(const char *path, FILE *file, char **text)
{
    *text = malloc(largest_bytes + 1);
    if (*text == NULL) {
        fprintf(stderr, "%s: out of memory\n", path);
        return EXK_INPUT_UNREADABLE;
    }
    errno = 0;
    const size_t n = fill(file, *text, largest_bytes);
    const int code = judge(path, file, *text, n);
    if (code != 0) {
        free(*text);
        *text = NULL;
        return code;
    }
    char *fitting = realloc(*text, n + 1);
    *text = fitting != NULL ? fitting : *text;
    return 0;
}

int exk_input_read(const char *path, char **text)
{
    *text = NULL;
    FILE *file = fopen(path, "r");
    if (file == NULL) {
        fprintf(stderr, "%s: cannot be opened: %s\n", path, strerror(errno));
        return EXK_INPUT_UNREADABLE;
    }
    const int code = read_stream(path, file, text);
    fclose(file);
    return code;
}

void exk_input_beside(const char *beside, const char *file, char *out, size_t size)
{
    const char *slash = strrchr(beside, '/');
    if (file[0] == '/' || slash == NULL) {
        snprintf(out, size, "%s", file);
    } else {
        snprintf(out, size, "%.*s/%s", (int)(slash - beside), beside, file);
    }
}

void exk_input_print(const char *path, const exk_fault *faults, size_t n_faults)
{
    const size_t n_shown = n_faults < EXK_FAULTS_MAX ? n_faults : EXK_FAULTS_MAX;
    for (size_t i = 0; i < n_shown; i++) {
        if (faults[i].line > 0) {
            fprintf(stderr, "%s:%d: %s\n", path, faults[i].line, faults[i].message);
        } else {
            fprintf(stderr, "%s: %s\n", path, faults[i].message);
        }
    }
    if (n_faults > n_shown) {
        fprintf(stderr, "%s: and %zu more\n", path, n_faults - n_shown);
    }
}

static void name_from_path(const char *path, char name[EXK_NAME_MAX])
{
    const char *slash = strrchr(path, '/');
    const char *base = slash == NULL ? path : slash + 1;
    const char *dot = strrchr(base, '.');
    const int length = dot == NULL || dot == base ? (int)strlen(base) : (int)(dot - base);
    snprintf(name, EXK_NAME_MAX, "%.*s", length, base);
}

int exk_input_parse(const char *path, const char *text, exk_profile *profile)
{
    exk_fault faults[EXK_FAULTS_MAX];
    size_t n_faults = 0;
    *profile = exk_profile_default();
    if (exk_profile_parse(text, profile, faults, EXK_FAULTS_MAX, &n_faults) != EXK_OK) {
        exk_input_print(path, faults, n_faults);
        return EXK_INPUT_BAD;
    }
    name_from_path(path, profile->name);
    return 0;
}

int exk_input_profile(const char *path, exk_profile *profile)
{
    char *text = NULL;
    int code = exk_input_read(path, &text);
    if (code == 0) {
        code = exk_input_parse(path, text, profile);
    }
    free(text);
    return code;
}
