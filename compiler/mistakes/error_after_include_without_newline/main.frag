#include "a.glsl"
out vec4 color;
void main() { color = vec4(one() + two()); }
