out vec4 color;
void main() {
  break;
  color = vec4(1.0);
}
