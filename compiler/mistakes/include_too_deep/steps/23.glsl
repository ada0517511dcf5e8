#include "24.glsl"
