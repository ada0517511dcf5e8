#include "11.glsl"
