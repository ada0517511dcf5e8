#include "41.glsl"
