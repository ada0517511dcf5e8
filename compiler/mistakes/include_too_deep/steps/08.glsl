#include "09.glsl"
