/* A profile of any bytes: refused with a reason, or printed and read back to the same text. */
#include <string.h>

#include "exk/profile.h"
#include "fuzz.h"

enum { FAULTS = 8, TEXT = 1 << 16 };

static void refused_with_reasons(const exk_fault faults[], size_t n)
{
    PROMISE(n > 0);
    for (size_t i = 0; i < n && i < FAULTS; i++) {
        PROMISE(faults[i].line >= 0);
        PROMISE(faults[i].message[0] != '\0');
        PROMISE(memchr(faults[i].message, '\0', sizeof faults[i].message) != NULL);
    }
}

static void reads_back(const exk_profile *profile)
{
    static char first[TEXT], second[TEXT];
    exk_profile again;
    exk_fault faults[FAULTS];
    size_t n = 0;
    PROMISE(exk_profile_print(profile, first, sizeof first) < sizeof first);
    PROMISE(exk_profile_parse(first, &again, faults, FAULTS, &n) == EXK_OK);
    PROMISE(exk_profile_print(&again, second, sizeof second) < sizeof second);
    PROMISE(strcmp(first, second) == 0);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    exk_profile profile;
    exk_fault faults[FAULTS];
    size_t n = 0;
    char *text = malloc(size + 1);
    PROMISE(text != NULL);
    if (size > 0) {
        memcpy(text, data, size);
    }
    text[size] = '\0';
    if (exk_profile_parse(text, &profile, faults, FAULTS, &n) == EXK_OK) {
        PROMISE(n == 0);
        reads_back(&profile);
    } else {
        refused_with_reasons(faults, n);
    }
    free(text);
    return 0;
}
