out vec4 color;
/* What main does
void main() { color = vec4(1.0); }
