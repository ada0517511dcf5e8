out vec4 color;
void main() {
  color = vec4(gnomon_shade(0.5));
}
