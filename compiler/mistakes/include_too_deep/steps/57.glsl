#include "58.glsl"
