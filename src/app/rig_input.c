#include "rig_input.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const size_t largest_text = (size_t)16 << 20;

static char *read_stream(FILE *file, const char *path)
{
    size_t n = 0;
    size_t room = 4096;
    char *text = malloc(room + 1);
    while (text != NULL) {
        n += fread(text + n, 1, room - n, file);
        if (n < room || room >= largest_text) {
            break;
        }
        room *= 2;
        char *larger = realloc(text, room + 1);
        if (larger == NULL) {
            free(text);
        }
        text = larger;
    }
    if (text == NULL || ferror(file) || n >= largest_text) {
        fprintf(stderr, "%s: cannot be read: %s\n", path,
                n >= largest_text ? "larger than 16 MiB" : strerror(errno));
        free(text);
        return NULL;
    }
    if (memchr(text, '\0', n) != NULL) {
        fprintf(stderr, "%s: not a text file: a zero byte stands in it\n", path);
        free(text);
        return NULL;
    }
    text[n] = '\0';
    return text;
}

char *rig_read_text(const char *path)
{
    FILE *file = fopen(path, "r");
    if (file == NULL) {
        fprintf(stderr, "%s: cannot be opened: %s\n", path, strerror(errno));
        return NULL;
    }
    char *text = read_stream(file, path);
    fclose(file);
    return text;
}

void rig_path_beside(const char *beside, const char *file, char *out, size_t size)
{
    const char *slash = strrchr(beside, '/');
    if (file[0] == '/' || slash == NULL) {
        snprintf(out, size, "%s", file);
    } else {
        snprintf(out, size, "%.*s/%s", (int)(slash - beside), beside, file);
    }
}

void rig_print_faults(const char *path, const exk_fault *faults, size_t n_faults)
{
    const size_t n_shown = n_faults < RIG_FAULTS_MAX ? n_faults : RIG_FAULTS_MAX;
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
