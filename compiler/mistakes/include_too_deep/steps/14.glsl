#include "15.glsl"
