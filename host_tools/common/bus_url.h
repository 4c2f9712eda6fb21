/** The LCM URL a tool uses: what was given, else LCM_DEFAULT_URL, else the default of a profile. */
#ifndef EXK_TOOLS_BUS_URL_H
#define EXK_TOOLS_BUS_URL_H

#include <stddef.h>

/** given may be NULL. */
void exk_bus_url(const char *given, char *out, size_t size);

#endif
