#include "56.glsl"
