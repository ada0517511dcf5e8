// SPDX-License-Identifier: MIT
#include "gl/errors.h"

#include <glad/gl.h>

namespace gnomon::gl {

void clear_errors() {
  // A lost context reports an error for ever: bounded.
  for (int i = 0; i < 16 && glGetError() != GL_NO_ERROR; ++i) {
  }
}

}  // namespace gnomon::gl
