/** A file system in memory that can lose power: what was written and not synced may be gone, each write and
 *  each change of the folder on its own, and a write may be there in part.
 *
 *  Calls    every call that changes something is counted; call number cut and all after it do nothing
 *           and fail (the power is off). fail: that one call fails and the system lives on.
 *  Ops      a write to a file since its last fsync: lost, its first half, or whole. A change of the
 *           folder since the folder's fsync: lost or there; a rename sets the new name and then clears the
 *           old one, and the second may be lost alone. fsync of a file does not keep its name.
 *  Choices  power_fs_after(fs, n, choice) is the file system after the power came back, choice 0 .. n-1.
 */
#ifndef EXK_POWER_FS_H
#define EXK_POWER_FS_H

#include <stdbool.h>
#include <stddef.h>

#include "../../src/store/store_os.h"

enum {
    FS_FILES = 10,
    FS_NAMES = 6,
    FS_BYTES = 1024,
    FS_OPS = 24,
    FS_FDS = 4,
    FS_NAME_MAX = 32
};

typedef struct {
    unsigned char bytes[FS_BYTES];
    size_t n;
} fs_data;

typedef struct {
    char name[FS_NAME_MAX];
    int file; /* -1: none */
} fs_name;

typedef enum { FS_WRITE, FS_SET, FS_CLEAR } fs_op_kind;

typedef struct {
    fs_op_kind kind;
    int name;
    int file;
    size_t at; /* write: where, how much of the file's present bytes */
    size_t n;
    bool follows; /* clear: cannot be there without the op before it */
} fs_op;

typedef struct {
    fs_data kept[FS_FILES]; /* on the disk for sure */
    fs_data now[FS_FILES];  /* as programs see it */
    int n_files;
    fs_name kept_names[FS_NAMES];
    fs_name now_names[FS_NAMES];
    int n_names;
    fs_op ops[FS_OPS]; /* not synced */
    int n_ops;
    struct {
        int file; /* -1: the folder, -2: closed */
        size_t at;
    } fds[FS_FDS];
    size_t write_max; /* most that one write takes */
    bool no_links;
    bool no_fsync; /* fsync says yes and does nothing: what the test must find out */
    int n_calls;
    int cut;  /* -1: never */
    int fail; /* -1: none */
} power_fs;

void power_fs_init(power_fs *fs);
store_os power_fs_calls(power_fs *fs);

/** How many outcomes a loss of power now has. */
long power_fs_outcomes(const power_fs *fs);

/** Outcome number choice, as a fresh file system. */
void power_fs_after(const power_fs *fs, long choice, power_fs *out);

/** Puts bytes under a name, synced. */
void power_fs_put(power_fs *fs, const char *name, const void *bytes, size_t n);

/** File of a name, -1 without. */
int power_fs_find(const power_fs *fs, const char *name);

#endif
