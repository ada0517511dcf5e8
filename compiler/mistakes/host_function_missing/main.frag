#include "relief.glsl"
out vec4 color;
void main() { color = vec4(slope(ivec2(1))); }
