// back to the first
#include "a.glsl"
