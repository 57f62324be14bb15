/* stability_cores_f32.c: the lobe operations in float. */
#define SG_PRECISION 32
#include "../lib/sg/real.h"

#include "../tables/out/forms.inc"

#include "stability_cores.inc"
