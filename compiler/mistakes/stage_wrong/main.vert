out vec4 color;
void main() {
  color = vec4(1.0);
  gl_FragDepth = 0.5;
}
