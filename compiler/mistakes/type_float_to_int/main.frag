out vec4 color;
void main() {
  int column = 0.5;
  color = vec4(column);
}
