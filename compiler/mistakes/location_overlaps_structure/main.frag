float scale(float gain) { return gain; }
struct Light {
  float power[2][3];
  float radius;
};
layout(location = 0) uniform Light light;
layout(location = 6) uniform float gain;
layout(location = 0) out vec4 colour;
void main() { colour = vec4(light.radius * scale(gain)); }
