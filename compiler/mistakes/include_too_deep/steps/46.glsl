#include "47.glsl"
