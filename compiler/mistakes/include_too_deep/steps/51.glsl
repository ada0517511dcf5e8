#include "52.glsl"
