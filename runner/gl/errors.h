// SPDX-License-Identifier: MIT
// GL's own error flag, for the files of gl/.
#pragma once

namespace gnomon::gl {

/// Forgets errors of earlier calls, so that the next one that is read belongs to what follows.
void clear_errors();

}  // namespace gnomon::gl
