
float six() {
  return TWICE(3.0);
}
