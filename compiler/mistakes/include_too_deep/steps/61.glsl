#include "62.glsl"
