#include "03.glsl"
