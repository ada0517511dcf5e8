#include "21.glsl"
