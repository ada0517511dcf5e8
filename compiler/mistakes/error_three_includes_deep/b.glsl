

#include "c.glsl"
