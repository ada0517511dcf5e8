#ifdef HAS_NOISE
#include "noise.glsl"
#endif
void main() {}
