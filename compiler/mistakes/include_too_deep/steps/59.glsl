#include "60.glsl"
