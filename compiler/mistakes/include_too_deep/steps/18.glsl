#include "19.glsl"
