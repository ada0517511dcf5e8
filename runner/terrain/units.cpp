// SPDX-License-Identifier: MIT
#include "terrain/units.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <string>
#include <utility>

namespace gnomon::terrain {

std::optional<double> metres_per(std::string_view unit) {
  constexpr double kFoot = 0.3048;
  constexpr double kSurveyFoot = 1200.0 / 3937.0;
  using Entry = std::pair<std::string_view, double>;
  constexpr std::array<Entry, 27> kUnits{{{"m", 1},
                                          {"metre", 1},
                                          {"meter", 1},
                                          {"metres", 1},
                                          {"meters", 1},
                                          {"km", 1000},
                                          {"kilometre", 1000},
                                          {"kilometer", 1000},
                                          {"dm", 0.1},
                                          {"decimetre", 0.1},
                                          {"decimeter", 0.1},
                                          {"cm", 0.01},
                                          {"centimetre", 0.01},
                                          {"centimeter", 0.01},
                                          {"mm", 0.001},
                                          {"ft", kFoot},
                                          {"foot", kFoot},
                                          {"feet", kFoot},
                                          {"international foot", kFoot},
                                          {"us survey foot", kSurveyFoot},
                                          {"us survey feet", kSurveyFoot},
                                          {"us_survey_foot", kSurveyFoot},
                                          {"foot_us", kSurveyFoot},
                                          {"us-ft", kSurveyFoot},
                                          {"us_ft", kSurveyFoot},
                                          {"ftus", kSurveyFoot},
                                          {"sfoot", kSurveyFoot}}};
  std::string name(unit);
  std::transform(name.begin(), name.end(), name.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  const auto found =
      std::find_if(kUnits.begin(), kUnits.end(), [&](const Entry& e) { return e.first == name; });
  return found == kUnits.end() ? std::nullopt : std::optional(found->second);
}

}  // namespace gnomon::terrain
