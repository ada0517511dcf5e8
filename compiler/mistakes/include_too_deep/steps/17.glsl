#include "18.glsl"
