out vec4 color;
float level() {
  return vec2(1.0);
}
void main() { color = vec4(level()); }
