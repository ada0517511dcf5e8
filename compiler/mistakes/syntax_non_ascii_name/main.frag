out vec4 color;
void main() {
  float höhe = 1.0;
  color = vec4(1.0);
}
