#include "23.glsl"
