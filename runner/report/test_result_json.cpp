// SPDX-License-Identifier: MIT
#include "report/test_result_json.h"

#include <cmath>
#include <concepts>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <type_traits>
#include <vector>

namespace gnomon::report {
namespace {

using nlohmann::json;

template <class T, class U>
concept Either = std::same_as<T, U> || std::same_as<T, const U>;

// What is sent, once for both directions: visit(key, member) for each member.

void visit_members(Either<judge::WorstPixel> auto& worst, const auto& visit) {
  visit("x", worst.x);
  visit("y", worst.y);
  visit("channel", worst.channel);
  visit("actual", worst.actual);
  visit("expected", worst.expected);
}

void visit_members(Either<judge::Verdict> auto& verdict, const auto& visit) {
  visit("expectation", verdict.expectation);
  visit("passed", verdict.passed);
  visit("measured", verdict.measured);
  visit("limit", verdict.limit);
  visit("worst", verdict.worst);
  visit("mismatches", verdict.mismatches);
  visit("in_band", verdict.in_band);
  visit("compared", verdict.compared);
}

void visit_members(Either<TestResult> auto& result, const auto& visit) {
  visit("id", result.id);
  visit("scene_file", result.scene_file);
  visit("description", result.description);
  visit("status", result.status);
  visit("error", result.error);
  visit("verdicts", result.verdicts);
  visit("reproduce", result.reproduce);
  visit("accept", result.accept);
  visit("golden_note", result.golden_note);
  visit("actual_exr", result.actual_exr);
  visit("expected_exr", result.expected_exr);
  visit("difference_png", result.difference_png);
  visit("actual_png", result.actual_png);
  visit("expected_png", result.expected_png);
  visit("seconds", result.seconds);
}

// JSON has no NaN and no infinities: they travel as strings.

json number_to_json(double number) {
  if (std::isfinite(number)) return number;
  return std::isnan(number) ? "nan" : number > 0 ? "inf" : "-inf";
}

double number_from_json(const json& value) {
  if (value.is_number()) return value.get<double>();
  if (value == "nan") return std::numeric_limits<double>::quiet_NaN();
  if (value == "inf") return std::numeric_limits<double>::infinity();
  if (value == "-inf") return -std::numeric_limits<double>::infinity();
  throw std::invalid_argument("expected a number, got " + value.dump());
}

Status status_from_json(const json& value) {
  for (const Status status :
       {Status::kPassed, Status::kFailed, Status::kInvalid, Status::kSkipped, Status::kMachine}) {
    if (value == status_text(status)) return status;
  }
  throw std::invalid_argument("no such status: " + value.dump());
}

struct Writer {
  static json of(const std::string& text) { return text; }
  static json of(bool flag) { return flag; }
  static json of(int number) { return number; }
  static json of(double number) { return number_to_json(number); }
  static json of(Status status) { return status_text(status); }
  template <class T>
  static json of(const std::optional<T>& value) {
    return value ? of(*value) : json();
  }
  template <class T>
  static json of(const std::vector<T>& values) {
    json array = json::array();
    for (const T& value : values) array.push_back(of(value));
    return array;
  }
  template <class T>
  static json of(const T& value) {
    json object = json::object();
    visit_members(value, [&](const char* key, const auto& member) { object[key] = of(member); });
    return object;
  }
};

/// Throws std::exception for whatever Writer would not write.
struct Reader {
  static void into(std::string& text, const json& value) { text = value.get_ref<const std::string&>(); }
  static void into(bool& flag, const json& value) { flag = value.get<bool>(); }
  static void into(int& number, const json& value) { number = value.get<int>(); }
  static void into(double& number, const json& value) { number = number_from_json(value); }
  static void into(Status& status, const json& value) { status = status_from_json(value); }
  template <class T>
  static void into(std::optional<T>& optional, const json& value) {
    if (!value.is_null()) into(optional.emplace(), value);
  }
  template <class T>
  static void into(std::vector<T>& values, const json& array) {
    for (const json& value : array) into(values.emplace_back(), value);
  }
  template <class T>
  static void into(T& object, const json& value) {
    visit_members(object, [&](const char* key, auto& member) { into(member, value.at(key)); });
  }
};

}  // namespace

std::string to_json(const TestResult& result) {
  constexpr int kOneLine = -1;
  return Writer::of(result).dump(kOneLine, ' ', false, json::error_handler_t::replace);
}

Result<TestResult> from_json(std::string_view line) {
  try {
    TestResult result;
    Reader::into(result, json::parse(line));
    return result;
  } catch (const std::exception& problem) {
    return Diagnostic{.message = std::string("not a test result: ") + problem.what(),
                      .failure = Failure::kMachine};
  }
}

}  // namespace gnomon::report
