#if 1 +
#endif
void main() {}
