#include <gnomon/core/height_map.glsl>
out vec4 color;
void main() { color = vec4(gnomon_host_height(ivec2(0), 0)); }
