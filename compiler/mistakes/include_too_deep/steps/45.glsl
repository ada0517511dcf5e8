#include "46.glsl"
