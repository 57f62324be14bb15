/* stability_cores_f64.c: the lobe operations in double. */
#define SG_PRECISION 64
#include "../lib/sg/real.h"

#include "../tables/out/forms.inc"

#include "stability_cores.inc"
