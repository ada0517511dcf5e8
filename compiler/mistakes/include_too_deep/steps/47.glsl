#include "48.glsl"
