#include "63.glsl"
