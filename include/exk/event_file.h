/** LCM event logs: written so that they always end at a whole record, read without trust.
 *
 *  Format   of LCM (sync word, number, stamp, lengths, channel, payload): what lcm-logger writes and
 *           lcm-logplayer reads.
 *  Write    through LCM's own eventlog functions to "PATH.part", renamed to PATH by close, so that a
 *           half-written log never looks whole; after a kill the part stays and can be read.
 *           A full disk: the part is cut at its last whole record and stays. What exists and is not
 *           an LCM log is never overwritten, and one part has one writer at a time.
 *  Stamps   the caller's: microseconds since 1970 UTC, or simulated time in a fast run.
 *  Read     every length is checked against the bytes that are there. A damaged place is skipped to
 *           the next sync word and counted; a file that ends inside a record says so.
 *           (LCM's reader allocates whatever a damaged header claims, and cannot tell a cut file.)
 *  Errors   false, or a code, with a message that names the file and what to do.
 *  Memory   create allocates the writer with a 256 KiB buffer, close releases it; write allocates
 *           nothing. The reader owns one buffer that grows to the largest record.
 */
#ifndef EXK_EVENT_FILE_H
#define EXK_EVENT_FILE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

/** True when a log may be written there: nothing is, or an empty file, or an LCM log; and the same of
 *  its part. */
bool exk_event_path_allowed(const char *path, char *why, size_t why_size);

typedef struct exk_event_writer exk_event_writer;

exk_event_writer *exk_event_writer_create(const char *path, char *why, size_t why_size);

/** False from the first failure on (disk full); exk_event_writer_why says which. */
bool exk_event_writer_add(exk_event_writer *writer, int64_t stamp_us, const char *channel,
                          const void *data, size_t bytes);

/** Hands to the system what is buffered, so that a kill loses nothing written before. */
bool exk_event_writer_flush(exk_event_writer *writer);

const char *exk_event_writer_why(const exk_event_writer *writer); /* empty while all is well */
int64_t exk_event_writer_count(const exk_event_writer *writer);   /* records taken */
int64_t exk_event_writer_bytes(const exk_event_writer *writer);   /* of these */

/** Flush, sync, rename, release. False: writing failed, the part stays, why says so. */
bool exk_event_writer_close(exk_event_writer *writer, char *why, size_t why_size);

/** Gives up: closes and removes the part. NULL is allowed. */
void exk_event_writer_drop(exk_event_writer *writer);

typedef enum {
    EXK_EVENT_OK,       /* channel, data, bytes and stamp_us hold one record */
    EXK_EVENT_END,      /* the file ended after a whole record */
    EXK_EVENT_CUT,      /* the file ended inside a record */
    EXK_EVENT_NO_MEMORY /* or the file could not be read */
} exk_event_status;

typedef struct {
    FILE *file;
    int64_t size;
    int64_t at;        /* where the next record should begin */
    int64_t n_damaged; /* places skipped */
    unsigned char *buffer;
    size_t capacity;
    int64_t stamp_us;
    char channel[64];
    const unsigned char *data;
    size_t bytes;
} exk_event_reader;

/** False: cannot be opened, is empty, or is not an LCM log. */
bool exk_event_reader_open(exk_event_reader *reader, const char *path, char *why,
                           size_t why_size);
exk_event_status exk_event_reader_next(exk_event_reader *reader);
void exk_event_reader_close(exk_event_reader *reader);

#endif
