#include "turn.glsl"
out vec4 color;
uniform mat3 turn;
void main() {
  color = vec4(turn * vec3(1.0), 1.0);
}
