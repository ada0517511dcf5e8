out vec4 color;
void main() {
  float shade = 0.5
  color = vec4(shade);
}
