
#include "b.glsl"
