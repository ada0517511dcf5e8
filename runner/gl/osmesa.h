// SPDX-License-Identifier: MIT
// OSMesa: Mesa's software renderer into memory, without devices or a window system. Private to gl/.
#pragma once

#include <string>

#include "gl/native.h"

namespace gnomon::gl {

/// What is missing, and which package brings it; empty: nothing.
[[nodiscard]] std::string osmesa_lacks();

/// An OpenGL 4.5 core context, not current yet.
[[nodiscard]] Opened open_osmesa();

}  // namespace gnomon::gl
