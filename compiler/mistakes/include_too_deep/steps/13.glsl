#include "14.glsl"
