#include "31.glsl"
