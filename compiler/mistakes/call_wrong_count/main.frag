out vec4 color;
float mix_heights(float a, float b, float t) { return mix(a, b, t); }
void main() {
  color = vec4(mix_heights(1.0, 2.0));
}
