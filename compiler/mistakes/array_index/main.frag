out vec4 color;
void main() {
  float levels[3];
  levels[3] = 1.0;
  color = vec4(levels[0]);
}
