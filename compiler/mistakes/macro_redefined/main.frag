#include "one.glsl"
#define LEVELS 8
out vec4 color;
void main() { color = vec4(LEVELS); }
