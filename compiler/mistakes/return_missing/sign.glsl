
float sign_of(float x) {
  x = 1.0;
}
