#include "20.glsl"
