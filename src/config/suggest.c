#include "suggest.h"

#include <string.h>

enum { NAME_MAX_SHOWN = 48 };

static char lower(char c)
{
    return c >= 'A' && c <= 'Z' ? (char)(c - 'A' + 'a') : c;
}

static bool same_start(const char *a, const char *b, size_t n)
{
    for (size_t i = 0; i < n; i++) {
        if (a[i] == '\0' || lower(a[i]) != lower(b[i])) {
            return false;
        }
    }
    return true;
}

/* Unit words that people end keys with; anything else after a known stem is another name. */
static bool is_unit_word(const char *word)
{
    static const char *const units[] = {
        "m",     "mm",      "um",     "nm",     "cm",       "km",    "in",     "inch",
        "rad",   "mrad",    "urad",   "deg",    "arcsec",   "radps", "radps2", "degps",
        "s",     "ms",      "us",     "ns",     "sec",      "min",   "hz",     "khz",
        "mhz",   "mps",     "mmps",   "mmpmin", "mpmin",    "mps2",  "mmps2",  "g",
        "per_s", "per_min", "per_ms", "rad_s",  "rad_per_s"};
    for (size_t i = 0; i < sizeof(units) / sizeof(units[0]); i++) {
        if (strlen(units[i]) == strlen(word) && same_start(word, units[i], strlen(word))) {
            return true;
        }
    }
    return false;
}

/* True when name is the key but for its unit: another one, or none at all. */
static bool differs_in_unit(const exk_key *key, const char *name)
{
    const size_t suffix = strlen(key->unit->suffix);
    if (suffix == 0) {
        return false;
    }
    const size_t stem = strlen(key->name) - suffix; /* with its underscore */
    if (strlen(name) == stem - 1) {
        return same_start(name, key->name, stem - 1);
    }
    return same_start(name, key->name, stem) && is_unit_word(name + stem);
}

static bool add_unit_hint(exk_section_id section, const char *name, exk_text *out)
{
    size_t n = 0;
    for (size_t i = 0; i < exk_key_count(); i++) {
        const exk_key *key = exk_key_at(i);
        if (key->section == section && differs_in_unit(key, name)) {
            exk_text_add(out, "%s%s", n == 0 ? "wrong unit; write " : " or ", key->name);
            n++;
        }
    }
    return n > 0;
}

static size_t smallest(size_t a, size_t b, size_t c)
{
    const size_t ab = a < b ? a : b;
    return ab < c ? ab : c;
}

/* Letters to insert, drop or change (Levenshtein), one row of the table at a time. */
static size_t edits(const char *a, const char *b)
{
    size_t row[NAME_MAX_SHOWN + 1];
    const size_t n = strlen(b);
    if (n > NAME_MAX_SHOWN || strlen(a) > NAME_MAX_SHOWN) {
        return NAME_MAX_SHOWN;
    }
    for (size_t j = 0; j <= n; j++) {
        row[j] = j;
    }
    for (size_t i = 0; a[i] != '\0'; i++) {
        size_t diagonal = row[0];
        row[0] = i + 1;
        for (size_t j = 0; j < n; j++) {
            const size_t change = diagonal + (lower(a[i]) == lower(b[j]) ? 0 : 1);
            diagonal = row[j + 1];
            row[j + 1] = smallest(row[j + 1] + 1, row[j] + 1, change);
        }
    }
    return row[n];
}

static bool is_near(size_t distance, const char *name)
{
    const size_t allowed = strlen(name) / 3;
    return distance <= (allowed > 0 ? allowed : 1);
}

static bool add_nearest_key(exk_section_id section, const char *name, exk_text *out)
{
    const exk_key *nearest = NULL;
    size_t least = NAME_MAX_SHOWN;
    for (size_t i = 0; i < exk_key_count(); i++) {
        const exk_key *key = exk_key_at(i);
        if (key->section == section && edits(name, key->name) < least) {
            nearest = key;
            least = edits(name, key->name);
        }
    }
    if (nearest == NULL || !is_near(least, name)) {
        return false;
    }
    exk_text_add(out, "unknown key; did you mean %s?", nearest->name);
    return true;
}

static bool add_other_section(const char *name, exk_text *out)
{
    for (int id = EXK_IN_NOTHING + 1; id < EXK_IN_COUNT; id++) {
        if (exk_key_find((exk_section_id)id, name) < exk_key_count()) {
            exk_text_add(out, "unknown key here; it belongs to [%s]",
                         exk_section_of((exk_section_id)id)->name);
            return true;
        }
    }
    return false;
}

static void add_all_keys(exk_section_id section, exk_text *out)
{
    size_t n = 0;
    exk_text_add(out, "unknown key; allowed: ");
    for (size_t i = 0; i < exk_key_count(); i++) {
        if (exk_key_at(i)->section == section) {
            exk_text_add(out, "%s%s", n++ == 0 ? "" : ", ", exk_key_at(i)->name);
        }
    }
}

void exk_suggest_key(exk_section_id section, const char *name, exk_text *out)
{
    if (!add_unit_hint(section, name, out) && !add_other_section(name, out) &&
        !add_nearest_key(section, name, out)) {
        add_all_keys(section, out);
    }
}

void exk_suggest_section(const char *name, exk_text *out)
{
    for (int id = EXK_IN_NOTHING + 1; id < EXK_IN_COUNT; id++) {
        const char *stem = exk_section_of((exk_section_id)id)->stem;
        if (stem != NULL && strncmp(name, stem, strlen(stem) - 1) == 0) {
            exk_text_add(out, "unknown section; allowed: [%s1] to [%s%d]", stem, stem,
                         EXK_INSTANCES_MAX);
            return;
        }
    }
    exk_text_add(out, "unknown section; ");
    for (int id = EXK_IN_NOTHING + 1; id < EXK_IN_COUNT; id++) {
        const char *known = exk_section_of((exk_section_id)id)->name;
        if (is_near(edits(name, known), name)) {
            exk_text_add(out, "did you mean [%s]?", known);
            return;
        }
    }
    exk_text_add(out, "allowed:");
    for (int id = EXK_IN_NOTHING + 1; id < EXK_IN_COUNT; id++) {
        exk_text_add(out, " [%s]", exk_section_of((exk_section_id)id)->name);
    }
}
