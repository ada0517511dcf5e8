out vec4 color;
void paint() {
  return 1.0;
}
void main() { paint(); color = vec4(1.0); }
