layout(location = 0) in vec2 at;
layout(location = 0) out vec4 colour;
void main() {
  double sum = double(at.x) + double(at.y);
  colour = vec4(float(sum));
}
