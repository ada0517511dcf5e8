#define GL_SUN 1
out vec4 color;
void main() { color = vec4(GL_SUN); }
