/** What no single key shows: required keys, values derived from others, rules between keys. */
#ifndef EXK_CONFIG_CHECK_H
#define EXK_CONFIG_CHECK_H

#include "read.h"

void exk_check_profile(exk_profile_reader *reading);

#endif
