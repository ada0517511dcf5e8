#include "57.glsl"
