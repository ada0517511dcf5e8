#include "49.glsl"
