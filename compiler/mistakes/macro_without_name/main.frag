#define
void main() {}
