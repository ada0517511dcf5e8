#include "10.glsl"
