out vec4 color;
void main() {
  vec3 normal = vec2(0.0, 1.0);
  color = vec4(normal, 1.0);
}
