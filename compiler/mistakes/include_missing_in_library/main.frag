#include <gnomon/relief/multilvl.glsl>
void main() {}
