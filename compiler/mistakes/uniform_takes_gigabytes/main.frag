layout(std140) uniform Matrices {
  mat4 matrices[2000000000];
};
out vec4 colour;
void main() { colour = matrices[1][0]; }
