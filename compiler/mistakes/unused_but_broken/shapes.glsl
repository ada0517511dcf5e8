float cone(float r) { return 1.0 - r; }

float dome(float r) {
  return sqrt(1.0 - r * radius);
}
