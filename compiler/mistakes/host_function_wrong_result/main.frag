#include <gnomon/core/height_map.glsl>
int gnomon_host_height(ivec2 s, int q) { return 1; }
out vec4 color;
void main() { color = vec4(gnomon_host_height(ivec2(0), 0)); }
