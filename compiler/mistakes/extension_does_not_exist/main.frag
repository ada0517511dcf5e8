#extension GL_ARB_sunshine : require
void main() {}
