#include "07.glsl"
