/** Quantile of the standard normal distribution.
 *
 *  Errors  NaN for p outside (0, 1), NaN included.
 */
#ifndef EXK_QUANTILE_H
#define EXK_QUANTILE_H

double exk_normal_quantile(double p);

#endif
