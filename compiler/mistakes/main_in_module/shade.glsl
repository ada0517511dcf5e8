float shade() { return 0.5; }
void main() {}
