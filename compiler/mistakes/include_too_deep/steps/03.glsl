#include "04.glsl"
