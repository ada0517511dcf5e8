out vec4 color;
void main() {
  float gl_height = 1.0;
  color = vec4(gl_height);
}
