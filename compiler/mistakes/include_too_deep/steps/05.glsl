#include "06.glsl"
