#ifdef A
#else
#else
#endif
void main() {}
