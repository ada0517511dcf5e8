#include "66.glsl"
