float a;
#version 450
void main() {}
