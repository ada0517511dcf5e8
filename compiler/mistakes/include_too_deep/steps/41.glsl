#include "42.glsl"
