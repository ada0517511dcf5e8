#define QUALITY 2
out vec4 color;
void main() {
  color = vec4(QUALITY);
}
