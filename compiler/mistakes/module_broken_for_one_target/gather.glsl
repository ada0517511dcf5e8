vec4 four(sampler2D heights, vec2 at) {
  return textureGather(heights, at);
}
