// SPDX-License-Identifier: MIT
#include <common/colour.glsl>
#include <gnomon/core/map.glsl>

out vec4 o_colour;

void main() {
  GnomonReceiver receiver = gnomon_receiver_at(gl_FragCoord.x, gl_FragCoord.y, 0.0);
  o_colour = consumer_colour(receiver.fraction.x);
}
