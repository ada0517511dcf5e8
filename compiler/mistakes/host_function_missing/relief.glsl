// Metres.
float gnomon_host_height(ivec2 sample_index, int q);

float slope(ivec2 at) {
  return gnomon_host_height(at + ivec2(1, 0), 0) - gnomon_host_height(at, 0);
}
