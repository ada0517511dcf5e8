#include "59.glsl"
