/** Numbers in texts: independent of the locale, exact in both directions.
 *
 *  Units   a value of 12.5 mm is read as the decimal number 12.5e-3, so the nearest double of the
 *          SI value results and every double can be written. Degrees go through long double.
 *  Read    sign, digits, point, exponent; inf and nan in any case. Nothing before or after.
 *  Write   the shortest decimal text that reads back to the same bits.
 */
#ifndef EXK_CONFIG_NUMBER_H
#define EXK_CONFIG_NUMBER_H

#include <stdbool.h>

typedef struct {
    const char *suffix; /* as it ends a key: "mm", "" without a unit */
    const char *shown;  /* as people write it: "mm/s" */
    int exponent;       /* SI value = written value * 10^exponent */
    bool degrees;       /* SI value = written value * pi/180 */
} exk_unit;

extern const exk_unit exk_unit_none;

enum { EXK_NUMBER_SIZE = 64 };

/** False when the text is no number; out may become NaN or infinite. */
bool exk_number_read(const char *text, const exk_unit *unit, double *out);
void exk_number_write(double value, const exk_unit *unit, char out[EXK_NUMBER_SIZE]);

#endif
