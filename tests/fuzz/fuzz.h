/** What every fuzz target has: one call an input, and a promise that ends the process when broken.
 *
 *  Build   preset fuzz: libFuzzer calls it. All other builds: replay.c calls it with the kept corpus.
 */
#ifndef EXK_TEST_FUZZ_H
#define EXK_TEST_FUZZ_H

#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

/* Not assert: it holds in Release builds too. */
#define PROMISE(it_holds)                                                                      \
    do {                                                                                       \
        if (!(it_holds)) {                                                                     \
            fprintf(stderr, "%s:%d: broken: %s\n", __FILE__, __LINE__, #it_holds);             \
            abort();                                                                           \
        }                                                                                      \
    } while (0)

#endif
