#include "steps/01.glsl"
void main() {}
