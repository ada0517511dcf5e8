// Latin-1:
// Höhe
void main() {}
