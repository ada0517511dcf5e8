#ifndef A
#define A
#include "a.glsl"
#endif
