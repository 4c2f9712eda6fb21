#include "exk/args.h"
#include "exk/standard_streams.h"
#include "ilc_tool.h"

int main(int argc, char **argv)
{
    static int (*const run[])(const ilc_options *) = {
        [ILC_LEARN] = ilc_learn,
        [ILC_SHOW] = ilc_show,
        [ILC_VERIFY] = ilc_verify,
        [ILC_TRAIN] = ilc_train,
    };
    ilc_options options;
    exk_standard_streams_hold();
    ilc_options_parse(argc, argv, &options);
    const int code = run[options.command](&options);
    return exk_args_stdout_is_whole("exk-ilc") ? code : ILC_IO;
}
