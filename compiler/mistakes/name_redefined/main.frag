out vec4 color;
void main() {
  float shade = 0.5;
  int shade = 1;
  color = vec4(shade);
}
