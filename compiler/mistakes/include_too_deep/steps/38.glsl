#include "39.glsl"
