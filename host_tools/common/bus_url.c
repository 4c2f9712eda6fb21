#include "bus_url.h"

#include <stdio.h>
#include <stdlib.h>

#include "exk/profile.h"

void exk_bus_url(const char *given, char *out, size_t size)
{
    const char *environment = getenv("LCM_DEFAULT_URL");
    if (given != NULL) {
        snprintf(out, size, "%s", given);
    } else if (environment != NULL && *environment != '\0') {
        snprintf(out, size, "%s", environment);
    } else {
        const exk_profile profile = exk_profile_default();
        snprintf(out, size, "%s", profile.telemetry.url);
    }
}
