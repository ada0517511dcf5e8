out vec4 color;
uniform int hits;
void main() {
  color = vec4(0.0);
  if (hits) color = vec4(1.0);
}
