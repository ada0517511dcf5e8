#include "35.glsl"
