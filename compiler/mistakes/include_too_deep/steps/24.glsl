#include "25.glsl"
