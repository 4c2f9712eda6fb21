#define _POSIX_C_SOURCE 200809L
#define _XOPEN_SOURCE 700
#include "out_file.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

enum { HEAD_BYTES = 2048 };

static int fail(char *why, size_t why_size, const char *path, const char *what, int error)
{
    snprintf(why, why_size, "%s: %s: %s", path, what, strerror(error));
    return 3;
}

static bool begins_with(const char *head, const char *begins)
{
    return strncmp(head, begins, strlen(begins)) == 0;
}

static bool looks_ours(const char *head, size_t n, exk_out_kind kind, const char *begins)
{
    static const char png[] = "\x89PNG\r\n\x1a\n";
    switch (kind) {
    case EXK_OUT_SVG:
        return strstr(head, "<svg") != NULL && strstr(head, "Produced by GNUPLOT") != NULL;
    case EXK_OUT_PNG:
        return n >= sizeof png - 1 && memcmp(head, png, sizeof png - 1) == 0;
    case EXK_OUT_TEXT:
        return begins_with(head, begins);
    }
    return false;
}

static int refuse(exk_out *out, exk_out_kind kind, char *why, size_t why_size)
{
    static const char *const what[] = {
        [EXK_OUT_TEXT] = "an earlier result of this kind",
        [EXK_OUT_SVG] = "an SVG picture made by gnuplot",
        [EXK_OUT_PNG] = "a PNG picture",
    };
    snprintf(
        why, why_size,
        "%s: exists and is not %s, so it is left as it is: choose another name or remove it",
        out->shown, what[kind]);
    return 2;
}

/* An empty file is nobody's loss. */
static int check_existing(exk_out *out, exk_out_kind kind, const char *begins, char *why,
                          size_t why_size)
{
    char head[HEAD_BYTES + 1] = {0};
    FILE *old = fopen(out->path, "rb");
    if (old == NULL) {
        return fail(why, why_size, out->shown, "exists and cannot be read", errno);
    }
    const size_t n = fread(head, 1, HEAD_BYTES, old);
    fclose(old);
    if (n > 0 && !looks_ours(head, n, kind, begins)) {
        return refuse(out, kind, why, why_size);
    }
    return 0;
}

static int open_direct(exk_out *out, char *why, size_t why_size)
{
    out->file = fopen(out->path, "wb");
    return out->file != NULL ? 0 : fail(why, why_size, out->shown, "cannot be opened", errno);
}

static int open_temp(exk_out *out, mode_t mode, char *why, size_t why_size)
{
    const int n = snprintf(out->temp, sizeof out->temp, "%s.XXXXXX", out->path);
    if (n < 0 || (size_t)n >= sizeof out->temp) {
        return fail(why, why_size, out->shown, "cannot be written", ENAMETOOLONG);
    }
    const int fd = mkstemp(out->temp);
    if (fd < 0) {
        const int error = errno;
        out->temp[0] = '\0';
        return fail(why, why_size, out->shown, "cannot be written there", error);
    }
    (void)fchmod(fd, mode);
    out->file = fdopen(fd, "wb");
    if (out->file == NULL) {
        close(fd);
        exk_out_abort(out);
        return fail(why, why_size, out->shown, "cannot be written", ENOMEM);
    }
    return 0;
}

static mode_t default_mode(void)
{
    const mode_t mask = umask(0);
    umask(mask);
    return 0666 & ~mask;
}

/* The file behind a link is replaced, not the link. */
static int resolve(exk_out *out, char *why, size_t why_size)
{
    char *real = realpath(out->shown, NULL);
    const char *name = real != NULL ? real : out->shown;
    const bool fits = strlen(name) < sizeof out->path;
    if (fits) {
        memcpy(out->path, name, strlen(name) + 1);
    }
    free(real);
    return fits ? 0 : fail(why, why_size, out->shown, "cannot be written", ENAMETOOLONG);
}

int exk_out_open(exk_out *out, const char *path, exk_out_kind kind, const char *begins,
                 char *why, size_t why_size)
{
    struct stat st;
    out->shown = path;
    out->file = NULL;
    out->path[0] = out->temp[0] = '\0';
    if (strcmp(path, "-") == 0) {
        out->file = stdout;
        return 0;
    }
    if (resolve(out, why, why_size) != 0) {
        return 3;
    }
    if (stat(out->path, &st) != 0) {
        return open_temp(out, default_mode(), why, why_size);
    }
    if (S_ISDIR(st.st_mode)) {
        snprintf(why, why_size, "%s: is a folder: give the name of a file", path);
        return 2;
    }
    if (!S_ISREG(st.st_mode)) {
        return open_direct(out, why, why_size);
    }
    const int refused = check_existing(out, kind, begins, why, why_size);
    return refused != 0 ? refused : open_temp(out, st.st_mode & 0777, why, why_size);
}

static int close_file(exk_out *out)
{
    int error = 0;
    errno = 0;
    if (ferror(out->file) || fflush(out->file) != 0) {
        error = errno != 0 ? errno : EIO;
    }
    if (out->file == stdout) {
        return error;
    }
    if (error == 0 && out->temp[0] != '\0' && fsync(fileno(out->file)) != 0) {
        error = errno;
    }
    if (fclose(out->file) != 0 && error == 0) {
        error = errno;
    }
    return error;
}

int exk_out_commit(exk_out *out, char *why, size_t why_size)
{
    int error = close_file(out);
    out->file = NULL;
    if (error == 0 && out->temp[0] != '\0' && rename(out->temp, out->path) != 0) {
        error = errno;
    }
    if (error == 0) {
        out->temp[0] = '\0';
        return 0;
    }
    exk_out_abort(out);
    const char *name = strcmp(out->shown, "-") == 0 ? "standard output" : out->shown;
    return fail(why, why_size, name, "could not be written", error);
}

void exk_out_abort(exk_out *out)
{
    if (out->file != NULL && out->file != stdout) {
        fclose(out->file);
    }
    if (out->temp[0] != '\0') {
        unlink(out->temp);
    }
    out->file = NULL;
    out->temp[0] = '\0';
}

int exk_stdout_flush(const char *program)
{
    errno = 0;
    if (fflush(stdout) == 0 && !ferror(stdout)) {
        return 0;
    }
    fprintf(stderr, "%s: standard output: could not be written: %s\n", program,
            strerror(errno != 0 ? errno : EIO));
    return 3;
}
