#include "30.glsl"
