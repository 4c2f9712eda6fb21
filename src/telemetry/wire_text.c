#include "wire_text.h"

#include <stdio.h>
#include <string.h>

int32_t exk_wire_int_at(const void *data, size_t at)
{
    const unsigned char *b = (const unsigned char *)data + at;
    const uint32_t value =
        (uint32_t)b[0] << 24 | (uint32_t)b[1] << 16 | (uint32_t)b[2] << 8 | b[3];
    int32_t out;
    memcpy(&out, &value, sizeof out);
    return out;
}

bool exk_wire_skip_text(const void *data, size_t bytes, size_t *at)
{
    if (*at > bytes || bytes - *at < 4) {
        return false;
    }
    const int32_t length = exk_wire_int_at(data, *at); /* with the final NUL */
    const size_t begin = *at + 4;
    if (length < 1 || (size_t)length > bytes - begin) {
        return false;
    }
    const size_t end = begin + (size_t)length;
    if (((const unsigned char *)data)[end - 1] != 0) {
        return false;
    }
    *at = end;
    return true;
}

void exk_wire_copy_text(char *to, size_t size, const char *from)
{
    snprintf(to, size, "%s", from);
}
