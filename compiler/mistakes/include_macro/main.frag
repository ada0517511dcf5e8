#define METHOD "a.glsl"
#include METHOD
void main() {}
