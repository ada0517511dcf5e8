#include "44.glsl"
