#include "26.glsl"
