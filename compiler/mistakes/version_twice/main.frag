#version 450
#version 330
void main() {}
