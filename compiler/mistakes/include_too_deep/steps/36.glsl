#include "37.glsl"
