#include "61.glsl"
