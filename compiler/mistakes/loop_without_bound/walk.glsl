float walk(float x) {
  while (x < 10.0) x *= 1.5;
  return x;
}
