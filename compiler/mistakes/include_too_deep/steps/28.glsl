#include "29.glsl"
