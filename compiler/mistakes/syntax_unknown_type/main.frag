out vec4 color;
void main() {
  float3 p = float3(1.0);
  color = vec4(p, 1.0);
}
