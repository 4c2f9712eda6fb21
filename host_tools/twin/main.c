/** exk-twin: the machine in a process of its own. See options.c for its use. */
#define _POSIX_C_SOURCE 200809L
#include <inttypes.h>
#include <stdio.h>
#include <sys/prctl.h>
#include <unistd.h>

#include "exk/realtime.h"
#include "exk/solo.h"
#include "exk/standard_streams.h"
#include "exk/stop_signal.h"
#include "exk/store.h"
#include "options.h"
#include "server.h"

enum { EXIT_INPUT = 2, EXIT_IO = 3, WAIT_MS = 200 };

static int complain(int code, const char *why)
{
    fprintf(stderr, "exk-twin: %s\n", why);
    return code;
}

static int64_t own_id(void)
{
    char text[64];
    const int n = snprintf(text, sizeof text, "%" PRId64 " %ld", exk_wall_us(), (long)getpid());
    return (int64_t)(exk_store_hash(text, (size_t)n) >> 1);
}

static int serve(const twin_options *options, twin_server *server)
{
    while (exk_stop_signal() == 0 && !(options->once && server->over)) {
        if (exk_bus_wait(server->bus, WAIT_MS) < 0) {
            return complain(EXIT_IO,
                            "the bus cannot be read any more: exk-doctor finds out why");
        }
    }
    return 0;
}

static int run(const twin_options *options, exk_rig *rig)
{
    static twin_server server;
    char why[1024];
    const char *url = options->url != NULL ? options->url : rig->profile.telemetry.url;
    if (!exk_bus_url_good(url, why, sizeof why) ||
        !exk_solo_claim("machine", url, why, sizeof why)) {
        return complain(EXIT_INPUT, why);
    }
    server = (twin_server){.rig = rig, .quiet = options->quiet, .machine_id = own_id()};
    exk_rights_fifo(rig->profile.timing.priority -
                    2); /* LCM's thread too; ordinary if refused */
    server.bus = exk_bus_open(url, true, why, sizeof why);
    if (server.bus == NULL || !exk_bus_listen(server.bus, EXK_CHANNEL_DRIVE,
                                              twin_server_receive, &server, why, sizeof why)) {
        exk_bus_close(server.bus);
        return complain(EXIT_IO, why);
    }
    prctl(PR_SET_TIMERSLACK, 1UL, 0UL, 0UL, 0UL);
    if (!options->quiet) {
        fprintf(stderr, "exk-twin: the machine of %s is on %s\n", rig->profile.name, url);
    }
    const int code = serve(options, &server);
    exk_bus_close(server.bus);
    return code;
}

int main(int argc, char **argv)
{
    twin_options options;
    exk_rig rig;
    exk_standard_streams_hold();
    twin_options_parse(argc, argv, &options);
    exk_stop_catch();
    int code = exk_rig_open(&rig, options.profile_path);
    if (code == 0) {
        code = run(&options, &rig);
        exk_rig_close(&rig);
    }
    return code;
}
