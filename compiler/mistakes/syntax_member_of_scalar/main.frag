out vec4 color;
void main() {
  float h = 1.0;
  color = vec4(h.w);
}
