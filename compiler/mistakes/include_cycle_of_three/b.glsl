#include "c.glsl"
