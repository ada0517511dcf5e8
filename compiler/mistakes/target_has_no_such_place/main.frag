vec4 pick(vec4 last) { return last; }
layout(binding = 16) uniform sampler2D last;
layout(location = 0) out vec4 colour;
void main() { colour = pick(texture(last, vec2(0.5))); }
