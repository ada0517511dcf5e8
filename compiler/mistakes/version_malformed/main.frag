#version latest
void main() {}
