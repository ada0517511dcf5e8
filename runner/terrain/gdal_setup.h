// SPDX-License-Identifier: MIT
// GDAL as a silent library. Internal to this folder.
#pragma once

#include <string>

namespace gnomon::terrain {

/// Registers the formats that this folder reads and writes, and keeps GDAL from touching any other file: no
/// .aux.xml, no listing of folders, no network. May be called from any thread, as often as one likes.
void set_up_gdal();

/// While it lives, this thread's GDAL messages are kept instead of printed.
class GdalMessages {
 public:
  GdalMessages();
  ~GdalMessages();
  GdalMessages(const GdalMessages&) = delete;
  GdalMessages& operator=(const GdalMessages&) = delete;

  /// The first line of the first failure since the last call; empty where there was none.
  [[nodiscard]] std::string take();
  [[nodiscard]] bool any() const { return !first_.empty(); }
  /// What GDAL reports, from its own handler.
  void hear(const char* message) {
    if (first_.empty()) first_ = *message ? message : "no reason given";
  }

 private:
  std::string first_{};
};

}  // namespace gnomon::terrain
