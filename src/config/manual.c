#include "exk/profile.h"
#include "keys.h"
#include "text.h"
#include "value.h"

static const char introduction[] =
    "# Profiles\n"
    "\n"
    "A profile is one experiment: one INI file, checked as a whole before anything starts. "
    "`exk-loop\n"
    "--check FILE` names every fault with its line; `exk-loop --print FILE` shows the "
    "effective\n"
    "profile, defaults filled in. This page is written by the program from its table of keys.\n"
    "\n"
    "A line is a `[section]`, a `key = value`, or a comment after `;` or `#`; after a value a "
    "comment\n"
    "starts with a blank and `;`. Lines have at most 198 characters. Names and words are\n"
    "case-sensitive, a number has a decimal point, and the end of a key is its unit. "
    "`[kinematics]`\n"
    "with `model` and `[job]` with `kind` are needed; whatever else is left out has its "
    "default.\n"
    "\n"
    "The shortest profile:\n"
    "\n"
    "    [kinematics]\n"
    "    model = pendulum\n"
    "    [job]\n"
    "    kind = rectangle\n";

static const char holes_page[] =
    "\n"
    "## Holes from a file\n"
    "\n"
    "`[job] kind = csv` reads a CSV beside the profile. Its first line names the columns, in "
    "any order:\n"
    "`id,x_mm,y_mm`, and if wanted `z_mm` (default: `plane_z_mm`) and `nx,ny,nz` together "
    "(direction\n"
    "from the machine into the part, of any length above 1e-6; default `0,0,1`). Ids are whole "
    "numbers,\n"
    "each once. Empty lines and lines after `#` are left out. At most 4096 holes.\n"
    "\n"
    "    id,x_mm,y_mm,nx,ny,nz\n"
    "    1,-120,80,0,0.02,1\n"
    "    2,-100,81.5,0,0.02,1\n";

static void add_default(const exk_profile *profile, const exk_key *key, exk_text *out)
{
    const char *base = exk_key_base(profile, key->section, 0);
    if (key->required) {
        exk_text_add(out, "needed");
    } else if (key->shown_default != NULL) {
        exk_text_add(out, "%s", key->shown_default);
    } else if (!exk_key_is_amplitude(key)) {
        exk_value_add(key, base + key->offset, out);
    }
}

static void add_row(const exk_profile *profile, const exk_key *key, exk_text *out)
{
    exk_text_add(out, "| `%s` | %s | ", key->name, key->unit->shown);
    exk_value_add_allowed(key, "", out);
    exk_text_add(out, " | ");
    add_default(profile, key, out);
    exk_text_add(out, " | %s |\n", key->meaning);
}

size_t exk_profile_manual(char *out, size_t size)
{
    const exk_profile profile = exk_profile_default();
    exk_text text = exk_text_start(out, size);
    exk_text_add(&text, "%s", introduction);
    for (int id = EXK_IN_NOTHING + 1; id < EXK_IN_COUNT; id++) {
        const exk_section *section = exk_section_of((exk_section_id)id);
        exk_text_add(&text, "\n## [%s]\n\n%s\n\n", section->name, section->meaning);
        exk_text_add(&text,
                     "| key | unit | allowed | default | meaning |\n|---|---|---|---|---|\n");
        for (size_t i = 0; i < exk_key_count(); i++) {
            if (exk_key_at(i)->section == (exk_section_id)id) {
                add_row(&profile, exk_key_at(i), &text);
            }
        }
    }
    exk_text_add(&text, "%s", holes_page);
    return text.length;
}
