#include "53.glsl"
