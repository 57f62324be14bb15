// method.glsl: the form that passes integrating lobes call: SG_METHOD_A_h(lambda, cos_theta), or
// SG_METHOD_L, which is that over the integral of the lobe alone. The program compiles such a pass
// again with another method's name in it where one is asked for.
#ifndef METHOD_GLSL
#define METHOD_GLSL

#ifndef SG_METHOD_A_h
#define SG_METHOD_A_h sg_A_h_standard
#define SG_METHOD_L sg_L_standard
#endif

#include "../sg.glsl"

#endif
