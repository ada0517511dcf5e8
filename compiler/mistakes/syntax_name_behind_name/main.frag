void main() {
  float a = 1.0;
  a = a b * 2.0;
}
