/** Numbers out of fuzz input: any bits as they come, or something near what is asked for. */
#ifndef EXK_TEST_NUMBERS_H
#define EXK_TEST_NUMBERS_H

#include <stddef.h>
#include <stdint.h>
#include <string.h>

typedef struct {
    const uint8_t *data;
    size_t left;
} numbers;

/** The next byte; 0 past the end. */
static inline uint8_t next_byte(numbers *in)
{
    if (in->left == 0) {
        return 0;
    }
    in->left--;
    return *in->data++;
}

/** Eight bytes as they are; 0 past the end. */
static inline double next_bits(numbers *in)
{
    double value = 0.0;
    if (in->left >= sizeof value) {
        memcpy(&value, in->data, sizeof value);
        in->data += sizeof value;
        in->left -= sizeof value;
    }
    return value;
}

/** Two bytes: a number within about center +- span. */
static inline double next_near(numbers *in, double center, double span)
{
    const int high = next_byte(in);
    const int word = 256 * high + next_byte(in);
    return center + span * (word / 32767.5 - 1.0);
}

#endif
