#if 0
#include "noise.glsl"
#endif
out vec4 color;
void main() {
  color = noise;
}
