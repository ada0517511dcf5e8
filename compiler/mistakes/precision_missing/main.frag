out vec4 color;
void main() {
  color = texture(heights, vec2(0.5));
}
