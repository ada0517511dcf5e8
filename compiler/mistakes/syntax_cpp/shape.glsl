float area(float width, float height) {
  auto size = width * height;
  return size;
}
