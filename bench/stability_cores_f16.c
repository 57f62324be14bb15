/* stability_cores_f16.c: the lobe operations in half. */
#include "stability_cores.h"

#ifdef SG_HAVE_F16

#define SG_PRECISION 16
#include "../lib/sg/real.h"

#include "../tables/out/forms.inc"

#include "stability_cores.inc"

#else

const stability_core stability_cores_f16[] = {{NULL, NULL, NULL, false}};

#endif
