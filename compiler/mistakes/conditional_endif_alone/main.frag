#ifdef A
#endif
#endif
void main() {}
