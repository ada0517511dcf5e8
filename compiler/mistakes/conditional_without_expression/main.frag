#if
#endif
void main() {}
