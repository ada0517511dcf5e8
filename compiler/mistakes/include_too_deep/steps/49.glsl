#include "50.glsl"
