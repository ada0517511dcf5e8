#include "34.glsl"
