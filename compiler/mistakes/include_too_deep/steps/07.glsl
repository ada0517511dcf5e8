#include "08.glsl"
