#include "28.glsl"
