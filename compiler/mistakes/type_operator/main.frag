out vec4 color;
uniform mat3 turn;
void main() {
  color = turn * vec4(1.0);
}
