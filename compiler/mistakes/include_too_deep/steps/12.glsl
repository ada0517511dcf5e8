#include "13.glsl"
