#include "38.glsl"
