#include "22.glsl"
