#include "16.glsl"
