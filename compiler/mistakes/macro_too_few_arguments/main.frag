#define SUM(a, b) ((a) + (b))
out vec4 color;
void main() {
  color = vec4(SUM(1.0));
}
