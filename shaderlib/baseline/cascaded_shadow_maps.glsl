// SPDX-License-Identifier: MIT
// summary: Cascaded shadow maps, what most engines cast terrain shadows with: approximate, to compare with.
// source:  Zhang et al. 2006, "Parallel-split shadow maps"; Dimitrov 2007, "Cascaded shadow maps"
// host:    gnomon_host_height, gnomon_host_light_nearness
// options: none
#ifndef GNOMON_BASELINE_CASCADED_SHADOW_MAPS_GLSL
#define GNOMON_BASELINE_CASCADED_SHADOW_MAPS_GLSL

#include <gnomon/core/shadow.glsl>
#include <gnomon/mesh/grid.glsl>
#include <gnomon/shading/lit.glsl>

#define GNOMON_MOST_CASCADES 4
#define GNOMON_WIDEST_FILTER 7

// A square of the light's view, whose texel (x, y) shows what lies at corner + (x, y) * texel .. (x + 1, y + 1) * texel.
struct GnomonCascade {
  vec2 corner;  // metres along `right` and `down` of the light
  float texel;  // metres a side
};

// What the sun saw of the mesh, and how it is asked.
struct GnomonLight {
  vec3 origin;      // metres, towards the sun of every point of the mesh
  vec3 right;       // unit vectors of the light's view, orthogonal to each other and to the sun's direction
  vec3 down;
  float range;      // metres from `origin` away from the sun, over which nearness falls from 1 to 0
  int size;         // texels a side of each cascade
  int cascades;     // how many there are, finest first
  int grid_step;    // of the mesh
  float bias;       // texels along the ray that the receiver is lifted by
  float slope_bias; // further texels for each tangent of the angle between sun and normal
  int filter_width; // texels a side of the filter: 1, 3, 5 or 7
  GnomonCascade cascade[GNOMON_MOST_CASCADES];
};

// 1 - distance / range of what the sun sees at a texel of a cascade; 0 where it sees nothing.
GNOMON_OPTIONAL
float gnomon_host_light_nearness(ivec2 texel, int cascade);

// Where a point of the light's plane, metres, lies in a cascade, texels.
vec2 gnomon_cascade_texel(GnomonCascade cascade, vec2 at) {
  return vec2((at.x - cascade.corner.x) / cascade.texel, (at.y - cascade.corner.y) / cascade.texel);
}

// The finest cascade that holds the point with its filter; `cascades` where none does.
int gnomon_cascade_of(GnomonLight light, vec2 at) {
  float margin = 0.5f * float(light.filter_width);
  for (int i = 0; i < GNOMON_MOST_CASCADES; ++i) {
    if (i >= light.cascades) break;
    vec2 texel = gnomon_cascade_texel(light.cascade[i], at);
    float least = min(texel.x, texel.y);
    float most = max(texel.x, texel.y);
    if (least >= margin && most <= float(light.size) - margin) return i;
  }
  return light.cascades;
}

// Metres that a receiver on the ground is lifted towards the sun, so that a mesh does not shadow itself through the texels'
// width, nor by the rounding of places far from the light's origin. facing: cosine of the angle between sun and normal,
// above 0.
float gnomon_cascade_bias(GnomonLight light, float texel, float facing) {
  float tangent = min(sqrt(max(1.0f - facing * facing, 0.0f)) / max(facing, 1e-3f), 64.0f);
  float widest = 0.5f * float(light.filter_width - 1);
  return texel * (light.bias + (light.slope_bias + widest) * tangent) + light.range * 5e-7f;
}

// The share of the filter's texels in which something lies nearer to the sun.
float gnomon_cascade_share(GnomonLight light, int cascade, vec2 texel, float nearness) {
  ivec2 first = ivec2(int(floor(texel.x)), int(floor(texel.y))) - ivec2(light.filter_width / 2, light.filter_width / 2);
  int hidden = 0;
  for (int y = 0; y < GNOMON_WIDEST_FILTER; ++y) {
    if (y >= light.filter_width) break;
    for (int x = 0; x < GNOMON_WIDEST_FILTER; ++x) {
      if (x >= light.filter_width) break;
      if (gnomon_host_light_nearness(first + ivec2(x, y), cascade) > nearness) hidden += 1;
    }
  }
  return float(hidden) / float(light.filter_width * light.filter_width);
}

// The receiver, a thousandth of a texel nearer to the sun where there is a surface: one on a node or an edge of the mesh
// belongs to the triangle that its ray crosses.
GnomonReceiver gnomon_towards_sun(GnomonMap map, GnomonReceiver receiver, vec3 to_sun, int q) {
  vec2 texels = vec2(to_sun.x / map.spacing.x, -to_sun.y / map.spacing.y);
  vec2 at = vec2(receiver.patch_index) - vec2(0.5f, 0.5f) + receiver.fraction;
  vec2 moved = clamp(at + texels * (1e-3f / max(length(texels), 1e-30f)), vec2(0.0f, 0.0f), map.domain);
  GnomonReceiver nearer = gnomon_receiver_at(moved.x, moved.y, receiver.height);
  if (gnomon_patch_has_surface(nearer.patch_index, q)) return nearer;
  return gnomon_on_surface(receiver, q);
}

// The ground under the receiver: the mesh, or the surface itself where a hole cuts the mesh's triangle away.
GnomonGridPoint gnomon_mesh_under(GnomonMap map, GnomonReceiver receiver, int step, int q) {
  vec2 at = vec2(receiver.patch_index) - vec2(0.5f, 0.5f) + receiver.fraction;
  GnomonGridPoint on = gnomon_grid_point(map, at.x, at.y, step, q);
  if (!on.hole) return on;
  float base = gnomon_host_height(receiver.patch_index, q);
  on.height = base + gnomon_patch_height(gnomon_patch(receiver.patch_index, base, q), receiver.fraction);
  on.normal = gnomon_surface_normal(map, receiver, q);
  return on;
}

// Metres that a receiver is lifted by: one above the ground needs the less for the ground's slope the higher it stands, and
// over ground that faces away none.
float gnomon_cascade_lift(GnomonLight light, float texel, GnomonGridPoint on, vec3 to_sun, float height) {
  float facing = dot(on.normal, to_sun);
  float least = gnomon_cascade_bias(light, texel, 1.0f);
  if (facing <= 0.0f) return least;
  return max(least, gnomon_cascade_bias(light, texel, facing) - height * (on.normal.z / facing));
}

// The share of the receiver's filter that is hidden from the sun, 0..1; steps: texels read. The receiver stands on the
// mesh, or above it. to_sun: unit vector, x east, y north, z up. A triangle that faces away from the sun is in shadow; a
// point outside of every cascade is lit.
GnomonShadow gnomon_cascaded_shadow_maps(GnomonMap map, GnomonReceiver receiver, vec3 to_sun, int q, GnomonLight light) {
  GnomonShadow without_ray = gnomon_shadow_without_ray(to_sun);
  if (without_ray.cause != GNOMON_CAUSE_UNDECIDED) return without_ray;
  GnomonReceiver here = gnomon_towards_sun(map, receiver, to_sun, q);
  GnomonGridPoint on = gnomon_mesh_under(map, here, light.grid_step, q);
  bool faces_away = dot(on.normal, to_sun) <= 0.0f;
  if (faces_away && receiver.height <= 0.0f) return gnomon_shadow(1.0f, 0, GNOMON_CAUSE_SURFACE);
  vec2 at = vec2(here.patch_index) - vec2(0.5f, 0.5f) + here.fraction;
  vec3 place = vec3(at.x * map.spacing.x, (map.domain.y - at.y) * map.spacing.y, on.height + receiver.height) - light.origin;
  vec2 plane = vec2(dot(place, light.right), dot(place, light.down));
  int cascade = gnomon_cascade_of(light, plane);
  if (cascade >= light.cascades) return gnomon_shadow(0.0f, 0, GNOMON_CAUSE_LEFT_MAP);
  GnomonCascade taken = light.cascade[cascade];
  float lifted = dot(place, to_sun) + gnomon_cascade_lift(light, taken.texel, on, to_sun, receiver.height);
  float nearness = (light.range + lifted) / light.range;
  float share = gnomon_cascade_share(light, cascade, gnomon_cascade_texel(taken, plane), nearness);
  int cause = share > 0.0f ? GNOMON_CAUSE_SURFACE : GNOMON_CAUSE_ABOVE_ALL;
  return gnomon_shadow(share, light.filter_width * light.filter_width, cause);
}

#endif
