/** What to say about a name that is not in the table. */
#ifndef EXK_CONFIG_SUGGEST_H
#define EXK_CONFIG_SUGGEST_H

#include "keys.h"
#include "text.h"

/** "unknown key; did you mean ...", "wrong unit; write ...", ... for a key of a section. */
void exk_suggest_key(exk_section_id section, const char *name, exk_text *out);

/** "unknown section; ..." */
void exk_suggest_section(const char *name, exk_text *out);

#endif
