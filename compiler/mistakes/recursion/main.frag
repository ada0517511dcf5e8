#include "sum.glsl"
out vec4 color;
void main() { color = vec4(sum(3)); }
