// SPDX-License-Identifier: MIT
// Animated GIF files, by OpenImageIO.
#pragma once

#include <memory>
#include <string>

#include "gnomon/diagnostic.h"
#include "image/image.h"

namespace gnomon::image {

/// Pictures of one size that follow each other and then begin again. GIF shows 256 colours a picture,
/// dithered here, and counts time in hundredths of a second.
class Animation {
 public:
  /// `rate`: pictures a second, 1 to 50. `path` is written by `write`, and named by failures.
  Animation(std::string path, double rate);
  Animation(Animation&&) noexcept;
  Animation& operator=(Animation&&) noexcept;
  ~Animation();

  /// Encodes a picture at once, so that long animations take little memory. Fails (kMachine) if OpenImageIO
  /// cannot, or for a picture of another size than the first.
  [[nodiscard]] Result<Done> add(const Picture& picture);

  /// Writes the file with the pictures so far, at least one; nothing can be added then. Atomic like
  /// write_exr.
  [[nodiscard]] Result<Done> write();

 private:
  struct Encoder;
  std::unique_ptr<Encoder> encoder_;
};

}  // namespace gnomon::image
