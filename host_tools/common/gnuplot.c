#define _POSIX_C_SOURCE 200809L
#include "gnuplot.h"

#include <errno.h>
#include <spawn.h>
#include <string.h>
#include <strings.h>
#include <sys/wait.h>
#include <unistd.h>

extern char **environ;

bool exk_plot_kind(const char *path, exk_out_kind *kind)
{
    const char *dot = strrchr(path, '.');
    if (dot == NULL || dot == path) {
        return false;
    }
    if (strcasecmp(dot, ".svg") == 0) {
        *kind = EXK_OUT_SVG;
        return true;
    }
    *kind = EXK_OUT_PNG;
    return strcasecmp(dot, ".png") == 0;
}

/* Both kinds come out alike: SVG counts fonts in pixels and draws marks larger. */
static void set_terminal(FILE *script, exk_out_kind kind, int width, int height)
{
    if (kind == EXK_OUT_SVG) {
        fprintf(script,
                "set terminal svg enhanced size %d,%d dynamic background '#ffffff' "
                "font 'DejaVu Sans,Helvetica,Arial,sans-serif,10' fontscale 1.333\n"
                "mark_size = 0.65\n",
                width, height);
    } else {
        fprintf(script,
                "set terminal pngcairo enhanced size %d,%d background '#ffffff' "
                "font 'DejaVu Sans,10'\nmark_size = 1.0\n",
                width, height);
    }
    fputs("set encoding utf8\n", script);
}

/* No background: that is the page's. */
static void set_stream_terminal(FILE *script, int width, int height)
{
    fprintf(script,
            "set terminal svg noenhanced size %d,%d dynamic font 'sans-serif,9.75' "
            "fontscale 1.333\nmark_size = 0.65\nset encoding utf8\n",
            width, height);
}

static int spawn(pid_t *pid, int in_fd, int out_fd, int err_fd)
{
    char program[] = "gnuplot";
    char defaults[] = "-d";
    char from_stdin[] = "-";
    char *const argv[] = {program, defaults, from_stdin, NULL};
    posix_spawn_file_actions_t files;
    posix_spawn_file_actions_init(&files);
    posix_spawn_file_actions_adddup2(&files, in_fd, STDIN_FILENO);
    posix_spawn_file_actions_adddup2(&files, out_fd, STDOUT_FILENO);
    posix_spawn_file_actions_adddup2(&files, err_fd, STDERR_FILENO);
    const int error = posix_spawnp(pid, "gnuplot", &files, NULL, argv, environ);
    posix_spawn_file_actions_destroy(&files);
    return error;
}

static int wait_for(pid_t pid)
{
    int status = 0;
    while (waitpid(pid, &status, 0) < 0 && errno == EINTR) {
    }
    return status;
}

/* The first line of text that gnuplot wrote to its stderr. */
static void first_words(FILE *err, char *out, size_t size)
{
    snprintf(out, size, "no reason given");
    rewind(err);
    char line[256];
    while (fgets(line, sizeof line, err) != NULL) {
        line[strcspn(line, "\n")] = '\0';
        const char *text = line + strspn(line, " \t^");
        if (*text != '\0') {
            snprintf(out, size, "%s", text);
            return;
        }
    }
}

static int run(FILE *script, FILE *out, const char *shown, FILE *err, char *why,
               size_t why_size)
{
    pid_t pid = 0;
    char words[256];
    rewind(script);
    const int error = spawn(&pid, fileno(script), fileno(out), fileno(err));
    if (error != 0) {
        snprintf(why, why_size,
                 "%s: gnuplot draws the pictures and cannot be started: %s: install it "
                 "(apt-get install gnuplot-nox) or leave the picture out",
                 shown, strerror(error));
        return 3;
    }
    const int status = wait_for(pid);
    if (WIFEXITED(status) && WEXITSTATUS(status) == 0) {
        return 0;
    }
    first_words(err, words, sizeof words);
    snprintf(why, why_size, "%s: gnuplot failed: %s", shown, words);
    return 3;
}

static int open_script(FILE **script, const char *shown, char *why, size_t why_size)
{
    *script = tmpfile();
    if (*script == NULL) {
        snprintf(why, why_size, "%s: no temporary file: %s", shown, strerror(errno));
        return 3;
    }
    return 0;
}

static int draw_into(FILE *out, const char *shown, FILE *script, char *why, size_t why_size)
{
    if (fflush(script) != 0 || ferror(script)) {
        snprintf(why, why_size, "%s: no temporary file: %s", shown, strerror(EIO));
        return 3;
    }
    FILE *err = tmpfile();
    if (err == NULL) {
        snprintf(why, why_size, "%s: no temporary file: %s", shown, strerror(errno));
        return 3;
    }
    const int code = run(script, out, shown, err, why, why_size);
    fclose(err);
    return code;
}

int exk_plot_stream(FILE *out, const char *shown, int width, int height, exk_draw_fn draw,
                    const void *ctx, char *why, size_t why_size)
{
    FILE *script = NULL;
    int code = open_script(&script, shown, why, why_size);
    if (code != 0) {
        return code;
    }
    set_stream_terminal(script, width, height);
    draw(script, ctx);
    code = draw_into(out, shown, script, why, why_size);
    fclose(script);
    return code;
}

int exk_plot_write(const char *path, int width, int height, exk_draw_fn draw, const void *ctx,
                   char *why, size_t why_size)
{
    exk_out_kind kind;
    exk_out out;
    FILE *script = NULL;
    if (!exk_plot_kind(path, &kind)) {
        snprintf(why, why_size, "%s: a picture ends in .svg or .png", path);
        return 2;
    }
    const int refused = exk_out_open(&out, path, kind, NULL, why, why_size);
    if (refused != 0) {
        return refused;
    }
    int code = open_script(&script, path, why, why_size);
    if (code == 0) {
        set_terminal(script, kind, width, height);
        draw(script, ctx);
        code = draw_into(out.file, path, script, why, why_size);
        fclose(script);
    }
    if (code != 0) {
        exk_out_abort(&out);
        return code;
    }
    return exk_out_commit(&out, why, why_size);
}
