out vec4 color;
void main() {
  float table[-1];
  color = vec4(1.0);
}
