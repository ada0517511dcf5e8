#include "33.glsl"
