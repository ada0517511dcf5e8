#include "32.glsl"
