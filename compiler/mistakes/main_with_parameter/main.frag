out vec4 color;
void main(int argc) {
  color = vec4(argc);
}
