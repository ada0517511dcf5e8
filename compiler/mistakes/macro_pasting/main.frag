#define JOIN(a, b) a ## b
out vec4 color;
void main() {
  float xy = 1.0;
  color = vec4(JOIN(x, z));
}
