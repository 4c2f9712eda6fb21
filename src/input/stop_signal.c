#define _POSIX_C_SOURCE 200809L
#include "exk/stop_signal.h"

#include <signal.h>
#include <stddef.h>

static volatile sig_atomic_t
    noted; /* written by the signal handler, and by exk_stop_catch before it */

static void note(int number)
{
    noted = number;
}

void exk_stop_catch(void)
{
    struct sigaction action = {.sa_handler = note};
    struct sigaction before;
    sigemptyset(&action.sa_mask);
    noted = 0;
    sigaction(SIGINT, &action, NULL);
    sigaction(SIGTERM, &action, NULL);
    if (sigaction(SIGHUP, NULL, &before) == 0 && before.sa_handler != SIG_IGN) {
        sigaction(SIGHUP, &action, NULL);
    }
    signal(SIGPIPE, SIG_IGN);
}

int exk_stop_signal(void)
{
    return noted;
}
