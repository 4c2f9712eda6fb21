/** Puts a departure from the profile into an opened rig.
 *
 *  Gains and noise are changed in place; another dwell or model needs a new plan, so the rig is then
 *  opened again from its changed profile. Errors: an exit code; the rig is closed then.
 */
#ifndef STUDY_VARIANT_H
#define STUDY_VARIANT_H

#include "experiments.h"

int study_vary(exk_rig *rig, study_experiment which, const study_variant *variant);

#endif
