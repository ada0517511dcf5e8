#include "a.glsl"
void main() {}
