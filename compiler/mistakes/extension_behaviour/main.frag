#extension GL_ARB_gpu_shader5 : demand
void main() {}
