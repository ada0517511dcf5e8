#include "55.glsl"
