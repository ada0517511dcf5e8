#include "macros.glsl"
#include "use.glsl"
void main() { }
