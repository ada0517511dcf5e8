out vec4 color;
void main() {
  color = vec4(later());
}
float later() { return 1.0; }
