#define _POSIX_C_SOURCE 200809L
#include "power_fs.h"

#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <string.h>

#include "unity.h"

enum { FOLDER = -1, CLOSED = -2 };

void power_fs_init(power_fs *fs)
{
    memset(fs, 0, sizeof *fs);
    for (int i = 0; i < FS_FDS; i++) {
        fs->fds[i].file = CLOSED;
    }
    fs->write_max = FS_BYTES;
    fs->cut = -1;
    fs->fail = -1;
}

/* True: this call does not happen. */
static bool dark(power_fs *fs)
{
    const int call = fs->n_calls++;
    errno = EIO;
    return (fs->cut >= 0 && call >= fs->cut) || call == fs->fail;
}

static bool is_off(const power_fs *fs)
{
    return fs->cut >= 0 && fs->n_calls > fs->cut;
}

static int slot_of(power_fs *fs, const char *name)
{
    for (int i = 0; i < fs->n_names; i++) {
        if (strcmp(fs->now_names[i].name, name) == 0) {
            return i;
        }
    }
    TEST_ASSERT_LESS_THAN(FS_NAMES, fs->n_names);
    const int i = fs->n_names++;
    snprintf(fs->now_names[i].name, FS_NAME_MAX, "%s", name);
    fs->now_names[i].file = -1;
    fs->kept_names[i] = fs->now_names[i];
    return i;
}

int power_fs_find(const power_fs *fs, const char *name)
{
    for (int i = 0; i < fs->n_names; i++) {
        if (strcmp(fs->now_names[i].name, name) == 0) {
            return fs->now_names[i].file;
        }
    }
    return -1;
}

static void note(power_fs *fs, fs_op op)
{
    TEST_ASSERT_LESS_THAN(FS_OPS, fs->n_ops);
    fs->ops[fs->n_ops++] = op;
}

static void set_name(power_fs *fs, int slot, int file)
{
    fs->now_names[slot].file = file;
    note(fs, (fs_op){.kind = FS_SET, .name = slot, .file = file});
}

static void clear_name(power_fs *fs, int slot, bool follows)
{
    fs->now_names[slot].file = -1;
    note(fs, (fs_op){.kind = FS_CLEAR, .name = slot, .file = -1, .follows = follows});
}

static int new_fd(power_fs *fs, int file)
{
    int fd = 0;
    while (fd < FS_FDS && fs->fds[fd].file != CLOSED) {
        fd++;
    }
    TEST_ASSERT_LESS_THAN(FS_FDS, fd);
    fs->fds[fd].file = file;
    fs->fds[fd].at = 0;
    return fd;
}

static int create(power_fs *fs, const char *path)
{
    if (dark(fs)) {
        return -1;
    }
    if (power_fs_find(fs, path) >= 0) {
        errno = EEXIST;
        return -1;
    }
    TEST_ASSERT_LESS_THAN(FS_FILES, fs->n_files);
    const int file = fs->n_files++;
    set_name(fs, slot_of(fs, path), file);
    return new_fd(fs, file);
}

static int do_open(void *ctx, const char *path, int flags)
{
    power_fs *fs = ctx;
    if ((flags & O_CREAT) != 0) {
        return create(fs, path);
    }
    if (is_off(fs)) {
        errno = EIO;
        return -1;
    }
    if (strcmp(path, ".") == 0) {
        return new_fd(fs, FOLDER);
    }
    const int file = power_fs_find(fs, path);
    errno = ENOENT;
    return file < 0 ? -1 : new_fd(fs, file);
}

static ssize_t do_read(void *ctx, int fd, void *bytes, size_t n)
{
    power_fs *fs = ctx;
    const fs_data *data = &fs->now[fs->fds[fd].file];
    const size_t left = data->n - fs->fds[fd].at;
    const size_t got = n < left ? n : left;
    memcpy(bytes, data->bytes + fs->fds[fd].at, got);
    fs->fds[fd].at += got;
    return (ssize_t)got;
}

static ssize_t do_write(void *ctx, int fd, const void *bytes, size_t n)
{
    power_fs *fs = ctx;
    if (dark(fs)) {
        return -1;
    }
    const int file = fs->fds[fd].file;
    fs_data *data = &fs->now[file];
    const size_t put = n < fs->write_max ? n : fs->write_max;
    TEST_ASSERT_LESS_OR_EQUAL(FS_BYTES, data->n + put);
    memcpy(data->bytes + data->n, bytes, put);
    note(fs, (fs_op){.kind = FS_WRITE, .file = file, .at = data->n, .n = put});
    data->n += put;
    return (ssize_t)put;
}

static off_t do_size(void *ctx, int fd)
{
    const power_fs *fs = ctx;
    return fs->fds[fd].file >= 0 ? (off_t)fs->now[fs->fds[fd].file].n : -1;
}

static bool is_of(const fs_op *op, int file)
{
    return file == FOLDER ? op->kind != FS_WRITE : op->kind == FS_WRITE && op->file == file;
}

static int do_fsync(void *ctx, int fd)
{
    power_fs *fs = ctx;
    if (dark(fs)) {
        return -1;
    }
    if (fs->no_fsync) {
        return 0;
    }
    const int file = fs->fds[fd].file;
    int n = 0;
    for (int i = 0; i < fs->n_ops; i++) {
        if (!is_of(&fs->ops[i], file)) {
            fs->ops[n++] = fs->ops[i];
        }
    }
    fs->n_ops = n;
    if (file == FOLDER) {
        memcpy(fs->kept_names, fs->now_names, sizeof fs->kept_names);
    } else {
        fs->kept[file] = fs->now[file];
    }
    return 0;
}

static int do_close(void *ctx, int fd)
{
    power_fs *fs = ctx;
    fs->fds[fd].file = CLOSED;
    return 0;
}

static int do_rename(void *ctx, const char *from, const char *to)
{
    power_fs *fs = ctx;
    if (dark(fs)) {
        return -1;
    }
    const int file = power_fs_find(fs, from);
    if (file < 0) {
        errno = ENOENT;
        return -1;
    }
    set_name(fs, slot_of(fs, to), file);
    clear_name(fs, slot_of(fs, from), true);
    return 0;
}

static int do_link(void *ctx, const char *from, const char *to)
{
    power_fs *fs = ctx;
    if (dark(fs)) {
        return -1;
    }
    if (fs->no_links || power_fs_find(fs, to) >= 0) {
        errno = fs->no_links ? EPERM : EEXIST;
        return -1;
    }
    set_name(fs, slot_of(fs, to), power_fs_find(fs, from));
    return 0;
}

static int do_unlink(void *ctx, const char *path)
{
    power_fs *fs = ctx;
    if (dark(fs)) {
        return -1;
    }
    if (power_fs_find(fs, path) < 0) {
        errno = ENOENT;
        return -1;
    }
    clear_name(fs, slot_of(fs, path), false);
    return 0;
}

store_os power_fs_calls(power_fs *fs)
{
    return (store_os){do_open,  do_read,   do_write, do_size,   do_fsync,
                      do_close, do_rename, do_link,  do_unlink, fs};
}

static int choices_of(const fs_op *op)
{
    return op->kind == FS_WRITE ? 3 : 2;
}

long power_fs_outcomes(const power_fs *fs)
{
    long n = 1;
    for (int i = 0; i < fs->n_ops; i++) {
        n *= choices_of(&fs->ops[i]);
    }
    return n;
}

static void keep_write(const power_fs *fs, const fs_op *op, int part, power_fs *out)
{
    const size_t n = part == 2 ? op->n : op->n / 2;
    fs_data *data = &out->kept[op->file];
    if (part == 0) {
        return;
    }
    if (data->n < op->at) { /* an earlier write is lost: a hole of zeros */
        memset(data->bytes + data->n, 0, op->at - data->n);
    }
    memcpy(data->bytes + op->at, fs->now[op->file].bytes + op->at, n);
    data->n = data->n > op->at + n ? data->n : op->at + n;
}

void power_fs_after(const power_fs *fs, long choice, power_fs *out)
{
    bool there = false;
    *out = *fs;
    for (int i = 0; i < fs->n_ops; i++) {
        const fs_op *op = &fs->ops[i];
        const int part = (int)(choice % choices_of(op));
        choice /= choices_of(op);
        if (op->kind == FS_WRITE) {
            keep_write(fs, op, part, out);
            continue;
        }
        there = part == 1 && (!op->follows || there);
        if (there) {
            out->kept_names[op->name].file = op->file;
        }
    }
    memcpy(out->now, out->kept, sizeof out->now);
    memcpy(out->now_names, out->kept_names, sizeof out->now_names);
    out->n_ops = 0;
    out->n_calls = 0;
    out->cut = -1;
    out->fail = -1;
    for (int i = 0; i < FS_FDS; i++) {
        out->fds[i].file = CLOSED;
    }
}

void power_fs_put(power_fs *fs, const char *name, const void *bytes, size_t n)
{
    const int file = fs->n_files++;
    const int slot = slot_of(fs, name);
    memcpy(fs->now[file].bytes, bytes, n);
    fs->now[file].n = n;
    fs->kept[file] = fs->now[file];
    fs->now_names[slot].file = file;
    fs->kept_names[slot].file = file;
}
