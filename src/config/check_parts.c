#include "check_parts.h"

#include <math.h>

#include "value.h"

exk_shown_number exk_check_show(double value)
{
    exk_shown_number shown;
    exk_number_write(round(value * 1e3) / 1e3, &exk_unit_none, shown.text);
    return shown;
}

int exk_check_line(const exk_profile_reader *r, exk_section_id section, int instance,
                   const char *name)
{
    const int line = exk_line_of_key(r, section, instance, name);
    return line != 0 ? line : r->section_line[instance][section];
}

bool exk_check_given(const exk_profile_reader *r, exk_section_id section, int instance,
                     const char *name)
{
    return exk_line_of_key(r, section, instance, name) != 0;
}

bool exk_check_refused(const exk_profile_reader *r, exk_section_id section, const char *name)
{
    const size_t i = exk_key_find(section, name);
    return i < exk_key_count() && r->refused[0][i];
}
