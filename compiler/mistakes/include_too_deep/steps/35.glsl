#include "36.glsl"
