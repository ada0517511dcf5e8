#include "05.glsl"
