struct Tree { vec3 place; float height; };
uniform Tree trees[100000];
out vec4 color;
void main() {
  color = vec4(trees[7].height);
}
