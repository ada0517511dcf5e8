#inlcude "a.glsl"
void main() {}
