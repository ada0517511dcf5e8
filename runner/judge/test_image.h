// SPDX-License-Identifier: MIT
// Small images for the tests of the judge.
#pragma once

#include <limits>
#include <string>
#include <vector>

#include "image/image.h"

namespace gnomon::judge::testing {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();

inline std::size_t at(const image::Image& image, int x, int y) {
  return static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) + static_cast<std::size_t>(x);
}

inline void add_channel(image::Image& image, const std::string& name, float value) {
  image.channels[name] = std::vector<float>(image.pixels(), value);
}

inline void set(image::Image& image, const std::string& channel, int x, int y, float value) {
  image.channels.at(channel)[at(image, x, y)] = value;
}

/// What a shadow method writes: a checker of shadow, everything valid, level 0.
inline image::Image shadow_image(int width, int height) {
  image::Image image{.width = width, .height = height, .channels = {}, .attributes = {}};
  for (const char* name : {"b_shadow", "k_shadow", "q", "steps"}) add_channel(image, name, 0);
  add_channel(image, "valid", 1);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const bool shadow = (x + y) % 2 == 1;
      set(image, "b_shadow", x, y, shadow ? 1.0F : 0.0F);
      set(image, "k_shadow", x, y, shadow ? 0.4F : 1.0F);
      set(image, "steps", x, y, static_cast<float>(x));
    }
  }
  return image;
}

/// Turns lit into shadow and back.
inline void flip_shadow(image::Image& image, int x, int y) {
  set(image, "b_shadow", x, y, 1 - image.channels.at("b_shadow")[at(image, x, y)]);
}

/// The image as a golden of it is stored: with the band's mask, without steps.
inline image::Image golden_of(image::Image image) {
  image.channels.erase("steps");
  add_channel(image, "band", 0);
  return image;
}

}  // namespace gnomon::judge::testing
