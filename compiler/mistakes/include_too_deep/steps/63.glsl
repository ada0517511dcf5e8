#include "64.glsl"
