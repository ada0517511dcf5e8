// SPDX-License-Identifier: MIT
// Files that are either whole or untouched.
#pragma once

#include <cstddef>
#include <span>
#include <string>

#include "gnomon/diagnostic.h"

namespace gnomon {

/// Replaces `path` by `bytes`: a temporary file beside it, flushed to the disk, then renamed. A symbolic link
/// is followed; a device or pipe is written to directly. On failure (Failure::kMachine: no such folder, not
/// writable, disk full) an older file stays whole and no other file remains.
[[nodiscard]] Result<Done> write_file_atomically(const std::string& path, std::span<const std::byte> bytes);

}  // namespace gnomon
