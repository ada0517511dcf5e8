#include "a.glsl"
void main() { one(); }
