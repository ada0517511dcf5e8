#include "40.glsl"
