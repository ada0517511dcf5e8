struct Light {
  vec3 at[2];
  float power;
};
layout(std140) uniform Lights {
  float gain;
  Light sun;
};
layout(location = 0) out vec4 colour;
void main() { colour = vec4(gain * sun.power); }
