out vec4 color;
float twice(float x) { return 2.0 * x; }
void main() {
  color = vec4(twice(vec2(1.0)));
}
