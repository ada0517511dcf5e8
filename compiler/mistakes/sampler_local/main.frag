out vec4 color;
void main() {
  sampler2D heights;
  color = texture(heights, vec2(0.5));
}
