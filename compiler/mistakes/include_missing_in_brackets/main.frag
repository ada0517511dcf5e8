#include <noise.glsl>
void main() {}
