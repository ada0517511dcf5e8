out vec4 color;
uniform float spacing;
void main() {
  spacing = 5.0;
  color = vec4(spacing);
}
