#define _POSIX_C_SOURCE 200809L
#include <errno.h>
#include <fcntl.h>
#include <sodium.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "exk/command.h"

enum { HEX_DIGITS = 2 * EXK_KEY_BYTES };

static bool is_private(const char *path, int fd, char *why, size_t why_size)
{
    struct stat info;
    if (fstat(fd, &info) != 0 || !S_ISREG(info.st_mode)) {
        snprintf(why, why_size, "%s: not a regular file: a key is kept in one", path);
        return false;
    }
    if (info.st_uid != geteuid()) {
        snprintf(why, why_size,
                 "%s: this key belongs to user %ld, not to the one that runs this (%ld): use a "
                 "key of its own",
                 path, (long)info.st_uid, (long)geteuid());
        return false;
    }
    if ((info.st_mode & 077U) != 0) {
        snprintf(why, why_size,
                 "%s: others may read or write this key (mode %04o): run chmod 600 on it, and "
                 "make a new key when it may have been read",
                 path, (unsigned)(info.st_mode & 07777U));
        return false;
    }
    return true;
}

static bool decode(const char *path, const char *text, size_t length, exk_key_secret *out,
                   char *why, size_t why_size)
{
    size_t n = 0;
    const char *end = NULL;
    const bool whole =
        (length == HEX_DIGITS || (length == HEX_DIGITS + 1 && text[HEX_DIGITS] == '\n')) &&
        sodium_hex2bin(out->bytes, sizeof out->bytes, text, HEX_DIGITS, NULL, &n, &end) == 0 &&
        n == EXK_KEY_BYTES && end == text + HEX_DIGITS;
    if (!whole) {
        snprintf(
            why, why_size,
            "%s: not a key: %d hexadecimal digits are allowed; exk-command keygen makes one",
            path, (int)HEX_DIGITS);
    }
    return whole;
}

static void say_unopened(const char *path, char *why, size_t why_size)
{
    const char *reason = errno == ELOOP
                             ? "a symbolic link is not followed: name the file itself"
                             : strerror(errno);
    snprintf(why, why_size, "%s: cannot open the key: %s%s", path, reason,
             errno == ENOENT ? " (exk-command keygen makes one)" : "");
}

bool exk_key_load(const char *path, exk_key_secret *out, char *why, size_t why_size)
{
    char text[HEX_DIGITS + 2] = {0};
    if (sodium_init() < 0) {
        snprintf(why, why_size, "libsodium cannot be set up");
        return false;
    }
    const int fd = open(path, O_RDONLY | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK);
    if (fd < 0) {
        say_unopened(path, why, why_size);
        return false;
    }
    bool good = is_private(path, fd, why, why_size);
    if (good) {
        const ssize_t length = read(fd, text, sizeof text);
        good = decode(path, text, length < 0 ? 0 : (size_t)length, out, why, why_size);
    }
    close(fd);
    sodium_memzero(text, sizeof text);
    return good;
}

bool exk_key_make(const char *path, char *why, size_t why_size)
{
    exk_key_secret key;
    char text[HEX_DIGITS + 2];
    if (sodium_init() < 0) {
        snprintf(why, why_size, "libsodium cannot be set up");
        return false;
    }
    const int fd = open(path, O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0600);
    if (fd < 0) {
        snprintf(why, why_size, "%s: cannot be made: %s%s", path, strerror(errno),
                 errno == EEXIST ? " (an existing file is never overwritten)" : "");
        return false;
    }
    randombytes_buf(key.bytes, sizeof key.bytes);
    sodium_bin2hex(text, HEX_DIGITS + 1, key.bytes, sizeof key.bytes);
    text[HEX_DIGITS] = '\n';
    const bool good = write(fd, text, HEX_DIGITS + 1) == HEX_DIGITS + 1 && fsync(fd) == 0;
    if (!good) {
        snprintf(why, why_size, "%s: cannot be written: %s", path, strerror(errno));
        unlink(path);
    }
    close(fd);
    sodium_memzero(text, sizeof text);
    exk_key_wipe(&key);
    return good;
}

void exk_key_wipe(exk_key_secret *key)
{
    sodium_memzero(key, sizeof *key);
}
