out vec4 color;
void main() {
  float half = 0.5;
  color = vec4(half);
}
