#if QUALITY > 1
#endif
void main() {}
