#include "43.glsl"
