#include "02.glsl"
