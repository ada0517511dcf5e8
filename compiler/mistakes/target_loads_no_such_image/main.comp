layout(local_size_x = 8) in;
layout(rgba16f, binding = 0) uniform image2D picture;
void main() {
  vec4 before = imageLoad(picture, ivec2(gl_GlobalInvocationID.xy));
  imageStore(picture, ivec2(gl_GlobalInvocationID.xy), before * 0.5);
}
