out vec4 color;
uniform int q;
void main() {
  switch (q) {
    case 1: color = vec4(1.0); break;
    case 1: color = vec4(0.5); break;
  }
}
