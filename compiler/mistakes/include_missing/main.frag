
#include "relief/hieght.glsl"
void main() {}
