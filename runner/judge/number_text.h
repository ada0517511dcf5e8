// SPDX-License-Identifier: MIT
// Numbers as a person reads them.
#pragma once

#include <string>

namespace gnomon::judge {

/// The shortest decimal that is this value: as single precision where it is one ("0.2", not
/// "0.20000000298023224").
[[nodiscard]] std::string number_text(double value);

/// A share of 1 in percent, three digits: "0.0137 %", and "0" for none.
[[nodiscard]] std::string percent_text(double share);

}  // namespace gnomon::judge
