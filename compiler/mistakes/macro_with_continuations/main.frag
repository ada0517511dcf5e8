#define SUM(a, b) \
  ((a) +  \
   (b))
out vec4 color;
void main() {
  float x = SUM(1.0, \
    2.0);
  color = vec4(y);
}
