layout(std430, binding = 0) readonly buffer Heights {
  float heights[];
};
out vec4 colour;
void main() { colour = vec4(heights[0]); }
