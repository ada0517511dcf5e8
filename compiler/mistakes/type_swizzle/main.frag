out vec4 color;
void main() {
  vec2 at = vec2(1.0);
  color = vec4(at.xyz, 1.0);
}
