layout(binding = 0) uniform sampler2D heights;
layout(location = 0) in vec2 at;
layout(location = 0) out vec4 colour;
void main() {
  const ivec2 corners[4] = ivec2[4](ivec2(0, 0), ivec2(2, 0), ivec2(0, 2), ivec2(2, 2));
  colour = textureGatherOffsets(heights, at, corners);
}
