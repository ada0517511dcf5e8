#include "begin.glsl"
float a;
#endif
void main() {}
