// SPDX-License-Identifier: MIT
layout(location = 0) in vec2 a_corner;
layout(location = 0) out vec3 v_normal;

void main() {
  v_normal = vec3(a_corner, 1.0);
  gl_Position = vec4(a_corner, 0.0, 1.0);
}
