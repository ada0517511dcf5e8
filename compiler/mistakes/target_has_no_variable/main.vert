layout(location = 0) in vec4 position;
void main() {
  gl_Position = position;
  gl_PointSize = 4.0;
}
