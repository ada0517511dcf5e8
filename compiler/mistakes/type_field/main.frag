out vec4 color;
struct Ray { vec3 origin; vec3 direction; };
void main() {
  Ray ray = Ray(vec3(0.0), vec3(1.0));
  color = vec4(ray.directoin, 1.0);
}
