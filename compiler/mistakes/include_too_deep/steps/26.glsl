#include "27.glsl"
