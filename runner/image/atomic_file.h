// SPDX-License-Identifier: MIT
// The atomic output that the compiler and the runner share, under the name that image's callers use.
#pragma once

#include "gnomon/atomic_file.h"

namespace gnomon::image {

using gnomon::write_file_atomically;

}  // namespace gnomon::image
