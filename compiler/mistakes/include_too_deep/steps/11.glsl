#include "12.glsl"
