#include "17.glsl"
