#include "65.glsl"
