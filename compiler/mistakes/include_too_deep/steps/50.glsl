#include "51.glsl"
