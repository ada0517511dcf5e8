#include "45.glsl"
