#include "number.h"

#include <float.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "exk/units.h"
#include "text.h"

enum { DIGITS_MAX = 220, EXPONENT_MAX = 100000 };

/* The project's double factor: 35 deg here is 35.0 * EXK_RAD_PER_DEG elsewhere, bit for bit. */
static const long double rad_per_deg = (long double)EXK_RAD_PER_DEG;

const exk_unit exk_unit_none = {"", "", 0, false};

static bool is_digit(char c)
{
    return c >= '0' && c <= '9';
}

static bool same_word(const char *text, const char *word)
{
    size_t i = 0;
    while (word[i] != '\0' && (text[i] == word[i] || text[i] == word[i] - 'a' + 'A')) {
        i++;
    }
    return word[i] == '\0' && text[i] == '\0';
}

/* The digits of a number without its point, and the exponent that makes up for it. */
typedef struct {
    char digits[DIGITS_MAX + 1];
    size_t n;
    int exponent;
} decimal;

static const char *read_digits(const char *text, decimal *d, int exponent_step)
{
    for (; is_digit(*text) && d->n < DIGITS_MAX; text++) {
        d->digits[d->n++] = *text;
        d->exponent += exponent_step;
    }
    return text;
}

static const char *read_exponent(const char *text, decimal *d)
{
    const bool negative = *text == '-';
    text += *text == '-' || *text == '+' ? 1 : 0;
    if (!is_digit(*text)) {
        return NULL;
    }
    int exponent = 0;
    for (; is_digit(*text); text++) {
        exponent = exponent < EXPONENT_MAX ? 10 * exponent + (*text - '0') : exponent;
    }
    d->exponent += negative ? -exponent : exponent;
    return text;
}

static bool read_decimal(const char *text, decimal *d)
{
    *d = (decimal){.n = 0};
    text = read_digits(text, d, 0);
    if (*text == '.') {
        text = read_digits(text + 1, d, -1);
    }
    if (d->n > 0 && (*text == 'e' || *text == 'E')) {
        text = read_exponent(text + 1, d);
    }
    return d->n > 0 && text != NULL && *text == '\0';
}

/* digits and exponent as one text without a point: strtod reads it alike in every locale. */
static double to_double(const decimal *d, const exk_unit *unit)
{
    char plain[DIGITS_MAX + 16];
    snprintf(plain, sizeof(plain), "%se%d", d->digits, d->exponent + unit->exponent);
    if (unit->degrees) {
        return (double)(strtold(plain, NULL) * rad_per_deg);
    }
    return strtod(plain, NULL);
}

bool exk_number_read(const char *text, const exk_unit *unit, double *out)
{
    const bool negative = *text == '-';
    text += *text == '-' || *text == '+' ? 1 : 0;
    double value;
    decimal d;
    if (same_word(text, "inf") || same_word(text, "infinity")) {
        value = (double)INFINITY;
    } else if (same_word(text, "nan")) {
        value = (double)NAN;
    } else if (read_decimal(text, &d)) {
        value = to_double(&d, unit);
    } else {
        return false;
    }
    *out = negative ? -value : value;
    return true;
}

/* Lays out digits d.ddd * 10^exponent: plain where that stays short, else with an exponent. */
static void lay_out(const char *digits, int n, int exponent, bool negative,
                    char out[EXK_NUMBER_SIZE])
{
    exk_text text = exk_text_start(out, EXK_NUMBER_SIZE);
    exk_text_add(&text, "%s", negative ? "-" : "");
    if (exponent < -5 || exponent > 15) {
        exk_text_add(&text, "%c%s%.*se%d", digits[0], n > 1 ? "." : "", n - 1, digits + 1,
                     exponent);
    } else if (exponent < 0) {
        exk_text_add(&text, "0.%.*s%.*s", -exponent - 1, "0000", n, digits);
    } else if (n <= exponent + 1) {
        exk_text_add(&text, "%.*s%.*s", n, digits, exponent + 1 - n, "000000000000000");
    } else {
        exk_text_add(&text, "%.*s.%.*s", exponent + 1, digits, n - exponent - 1,
                     digits + exponent + 1);
    }
}

/* Writes |value| with n digits; the digits are picked out of printf's text, whose point may be the
 * locale's. */
static void write_digits(long double value, int n, int unit_exponent, bool negative,
                         char out[EXK_NUMBER_SIZE])
{
    char raw[EXK_NUMBER_SIZE];
    char digits[EXK_NUMBER_SIZE] = "";
    snprintf(raw, sizeof(raw), "%.*Le", n - 1, value);
    const char *mark = strchr(raw, 'e');
    int kept = 0;
    for (const char *c = raw; c < mark; c++) {
        if (is_digit(*c)) {
            digits[kept++] = *c;
        }
    }
    lay_out(digits, kept, atoi(mark + 1) - unit_exponent, negative, out);
}

void exk_number_write(double value, const exk_unit *unit, char out[EXK_NUMBER_SIZE])
{
    if (!isfinite(value) || value == 0.0) {
        const char *word = isnan(value) ? "nan" : (value == 0.0 ? "0" : "inf");
        snprintf(out, EXK_NUMBER_SIZE, "%s%s", signbit(value) ? "-" : "", word);
        return;
    }
    const long double size = fabsl((long double)value);
    const long double written = unit->degrees ? size / rad_per_deg : size;
    double again = 0.0;
    for (int n = 1; n <= LDBL_DECIMAL_DIG && again != value; n++) {
        write_digits(written, n, unit->exponent, signbit(value) != 0, out);
        exk_number_read(out, unit, &again);
    }
}
