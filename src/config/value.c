#include "value.h"

#include <float.h>
#include <inttypes.h>
#include <math.h>
#include <string.h>

enum { ALLOWED_SIZE = 96, FOUND_SIZE = 64 };

static void add_number(exk_text *out, double value)
{
    char number[EXK_NUMBER_SIZE];
    exk_number_write(value, &exk_unit_none, number);
    exk_text_add(out, "%s", number);
}

static void add_words(const char *const *words, exk_text *out)
{
    for (size_t i = 0; words[i] != NULL; i++) {
        const char *separator = words[i + 1] == NULL ? " or " : ", ";
        exk_text_add(out, "%s%s", i == 0 ? "" : separator, words[i]);
    }
}

static void add_range(const exk_key *key, const char *unit, exk_text *out)
{
    const char *space = unit[0] == '\0' ? "" : " ";
    if (key->min == -DBL_MAX) {
        exk_text_add(out, "any finite number");
        return;
    }
    exk_text_add(out, "%s", key->above ? "above " : "");
    add_number(out, key->min);
    if (key->max < DBL_MAX) {
        exk_text_add(out, " to ");
        add_number(out, key->max);
        exk_text_add(out, "%s%s", space, unit);
    } else {
        exk_text_add(out, "%s%s%s%s", space, unit, key->above ? "" : " or more",
                     isinf(key->max) ? ", or inf" : "");
    }
}

void exk_value_add_allowed(const exk_key *key, const char *unit, exk_text *out)
{
    if (key->words != NULL) {
        add_words(key->words, out);
    } else if (key->type == EXK_KEY_SEED) {
        exk_text_add(out, "whole number, 0 to %" PRIu64, UINT64_MAX);
    } else if (key->type == EXK_KEY_TEXT) {
        exk_text_add(out, "text");
    } else {
        exk_text_add(out, "%s", key->type == EXK_KEY_INTEGER ? "whole number, " : "");
        add_range(key, unit, out);
    }
}

/* Every fault of a value reads alike: where, what, found, allowed. */
static bool refuse(const exk_key *key, const char *text, exk_faults *faults, int line,
                   const char *label, const char *what)
{
    char allowed[ALLOWED_SIZE];
    char found[FOUND_SIZE];
    exk_text allowed_text = exk_text_start(allowed, sizeof(allowed));
    exk_text found_text = exk_text_start(found, sizeof(found));
    exk_value_add_allowed(key, key->unit->shown, &allowed_text);
    exk_text_add_quoted(&found_text, text);
    exk_faults_add(faults, line, "%s: %s: found %s, allowed: %s", label, what, found, allowed);
    return false;
}

static const char *number_fault(const exk_key *key, const char *text, double *value)
{
    if (text[0] == '\0') {
        return "no value";
    }
    if (!exk_number_read(text, &exk_unit_none, value)) {
        return "not a number";
    }
    if (isnan(*value)) {
        return "NaN is no value";
    }
    const bool inside =
        *value <= key->max && (*value > key->min || (*value == key->min && !key->above));
    return inside ? NULL : "out of range";
}

static const char *read_number(const exk_key *key, const char *text, void *field)
{
    double value = 0.0;
    double value_si = 0.0;
    const char *fault = number_fault(key, text, &value);
    if (fault != NULL) {
        return fault;
    }
    exk_number_read(text, key->unit, &value_si);
    if (value != 0.0 && value_si == 0.0) {
        return "too small to tell from 0";
    }
    memcpy(field, &value_si, sizeof(value_si));
    return NULL;
}

static const char *read_integer(const exk_key *key, const char *text, void *field)
{
    double value = 0.0;
    const char *fault = number_fault(key, text, &value);
    if (fault == NULL && value != floor(value)) {
        return "not a whole number";
    }
    if (fault == NULL) {
        const int whole = (int)value;
        memcpy(field, &whole, sizeof(whole));
    }
    return fault;
}

static const char *read_seed(const char *text, void *field)
{
    uint64_t seed = 0;
    for (const char *c = text; *c != '\0'; c++) {
        if (*c < '0' || *c > '9') {
            return "not a whole number";
        }
        const uint64_t digit = (uint64_t)(*c - '0');
        if (seed > (UINT64_MAX - digit) / 10) {
            return "out of range";
        }
        seed = 10 * seed + digit;
    }
    memcpy(field, &seed, sizeof(seed));
    return text[0] == '\0' ? "no value" : NULL;
}

static void store_word(const exk_key *key, int word, void *field)
{
    const bool flag = word == 1;
    const bool channels[EXK_N_AXES] = {word != EXK_BETA, word != EXK_ALPHA};
    if (key->type == EXK_KEY_FLAG) {
        memcpy(field, &flag, sizeof(flag));
    } else if (key->type == EXK_KEY_CHANNEL) {
        memcpy(field, channels, sizeof(channels));
    } else {
        memcpy(field, &word, sizeof(word));
    }
}

static const char *read_word(const exk_key *key, const char *text, void *field)
{
    for (int i = 0; key->words[i] != NULL; i++) {
        if (strcmp(key->words[i], text) == 0) {
            store_word(key, i, field);
            return NULL;
        }
    }
    return text[0] == '\0' ? "no value" : "unknown word";
}

static const char *read_text(const char *text, void *field)
{
    const size_t length = strlen(text);
    if (length == 0 ||
        text[0] == ';') { /* "file =; note" is a comment to people, but not to inih */
        return "no value";
    }
    if (length >= EXK_PATH_MAX) {
        return "too long";
    }
    memcpy(field, text, length + 1);
    return NULL;
}

static const char *read_any(const exk_key *key, const char *text, void *field)
{
    switch (key->type) {
    case EXK_KEY_NUMBER:
        return read_number(key, text, field);
    case EXK_KEY_INTEGER:
        return read_integer(key, text, field);
    case EXK_KEY_SEED:
        return read_seed(text, field);
    case EXK_KEY_TEXT:
        return read_text(text, field);
    case EXK_KEY_WORD:
    case EXK_KEY_FLAG:
    case EXK_KEY_CHANNEL:
        break;
    }
    return read_word(key, text, field);
}

bool exk_value_read(const exk_key *key, const char *text, void *field, exk_faults *faults,
                    int line, const char *label)
{
    const char *what = read_any(key, text, field);
    return what == NULL || refuse(key, text, faults, line, label, what);
}

static int word_of(const exk_key *key, const void *field)
{
    int word = 0;
    bool flags[EXK_N_AXES] = {false, false};
    if (key->type == EXK_KEY_FLAG) {
        memcpy(flags, field, sizeof(flags[0]));
        return flags[0] ? 1 : 0;
    }
    if (key->type == EXK_KEY_CHANNEL) {
        memcpy(flags, field, sizeof(flags));
        return flags[EXK_ALPHA] && flags[EXK_BETA] ? EXK_N_AXES
                                                   : (flags[EXK_BETA] ? EXK_BETA : EXK_ALPHA);
    }
    memcpy(&word, field, sizeof(word));
    return word;
}

static void add_double(const exk_key *key, const void *field, exk_text *out)
{
    double value;
    char number[EXK_NUMBER_SIZE];
    memcpy(&value, field, sizeof(value));
    exk_number_write(value, key->unit, number);
    exk_text_add(out, "%s", number);
}

void exk_value_add(const exk_key *key, const void *field, exk_text *out)
{
    int whole = 0;
    uint64_t seed = 0;
    switch (key->type) {
    case EXK_KEY_NUMBER:
        add_double(key, field, out);
        break;
    case EXK_KEY_INTEGER:
        memcpy(&whole, field, sizeof(whole));
        exk_text_add(out, "%d", whole);
        break;
    case EXK_KEY_SEED:
        memcpy(&seed, field, sizeof(seed));
        exk_text_add(out, "%" PRIu64, seed);
        break;
    case EXK_KEY_TEXT:
        exk_text_add(out, "%s", (const char *)field);
        break;
    case EXK_KEY_WORD:
    case EXK_KEY_FLAG:
    case EXK_KEY_CHANNEL:
        exk_text_add(out, "%s", key->words[word_of(key, field)]);
        break;
    }
}
