#include "54.glsl"
