#include "sun.glsl"
#include "moon.glsl"
out vec4 color;
void main() { color = vec4(light()); }
