// SPDX-License-Identifier: MIT
// Files that are either whole or untouched.
#pragma once

#include <cstddef>
#include <span>
#include <string>

#include "gnomon/diagnostic.h"

namespace gnomon {

/// What a file is to hold.
struct FileContent {
  std::string path;  ///< empty: standard output
  std::span<const std::byte> bytes;
};

/// Replaces the files, all or none: a temporary file beside each, flushed to the disk, then all renamed. A
/// symbolic link is followed; a device, a pipe, standard output or another open descriptor is written to
/// directly, at its end, before any file is replaced. A file keeps its mode. Interrupts wait until it is
/// done. On failure (Failure::kMachine: no such folder, not writable, disk full, file size limit where
/// SIGXFSZ is ignored) older files stay whole and no other file remains.
[[nodiscard]] Result<Done> write_files_atomically(std::span<const FileContent> files);

/// One file.
[[nodiscard]] Result<Done> write_file_atomically(const std::string& path, std::span<const std::byte> bytes);

}  // namespace gnomon
