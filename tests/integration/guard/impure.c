/* What the guards must find. Linked nowhere. */
#include <stdio.h>
#include <stdlib.h>

void *exk_impure(size_t size);

static int n_calls;
static _Thread_local int n_calls_here = 1;
static const char *const names[] = {"constant", "table"}; /* allowed: .data.rel.ro */

void *exk_impure(size_t size)
{
    n_calls++;
    n_calls_here++;
    printf("%s %d %d\n", names[size % 2], n_calls, n_calls_here);
    return malloc(size);
}
