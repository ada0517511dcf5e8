out vec4 color;
void main() {
  float sun__height = 1.0;
  color = vec4(sun__height);
}
