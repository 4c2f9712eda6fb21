/** One value of the table: from text to field, from field to text, and what is allowed. */
#ifndef EXK_CONFIG_VALUE_H
#define EXK_CONFIG_VALUE_H

#include "faults.h"
#include "keys.h"
#include "text.h"

/** Reads text into the field; on a fault says it and leaves the field. label: "[job] rows". */
bool exk_value_read(const exk_key *key, const char *text, void *field, exk_faults *faults,
                    int line, const char *label);

void exk_value_add(const exk_key *key, const void *field, exk_text *out);

/** "above 0 to 60 deg", "twin or replay", ...; unit is key->unit->shown, or "" where it stands beside. */
void exk_value_add_allowed(const exk_key *key, const char *unit, exk_text *out);

#endif
