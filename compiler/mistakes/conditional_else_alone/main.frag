float a;
#else
void main() {}
