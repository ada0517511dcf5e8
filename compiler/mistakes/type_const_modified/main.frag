out vec4 color;
const int kSteps = 4;
void main() {
  kSteps = 5;
  color = vec4(kSteps);
}
