out vec4 color;
void main() {
  float sample = 1.0;
  color = vec4(sample);
}
