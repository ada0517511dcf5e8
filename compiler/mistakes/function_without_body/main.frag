float noise(vec2 at);
out vec4 color;
void main() { color = vec4(noise(vec2(0.0))); }
