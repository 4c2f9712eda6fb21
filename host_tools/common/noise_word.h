/** One word for reports: does the noise of a profile repeat from run to run?
 *
 *  none    nothing random or periodic acts
 *  frozen  what acts is the same in every run of a series (constants and sines always are)
 *  fresh   what acts is drawn anew in every run
 *  mixed   some of each
 *  replay  the angles come from a recorded log
 */
#ifndef EXK_TOOLS_NOISE_WORD_H
#define EXK_TOOLS_NOISE_WORD_H

#include "exk/profile.h"

const char *exk_noise_word(const exk_profile *profile);

#endif
