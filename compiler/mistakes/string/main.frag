out vec4 color;
void main() {
  color = "white";
}
