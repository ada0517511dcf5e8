// SPDX-License-Identifier: MIT
#include "refusal.h"

#include <algorithm>
#include <array>

namespace gnomon::compiler {
namespace {

bool has_stage(const Target& target, Stage stage) {
  return std::ranges::find(target.stages, stage) != target.stages.end();
}

// Whether a target got further than where another one refused.
bool gets_further(const Request& request, const Target& target, const Refusal& refusal) {
  const Result<Attempt> other = attempt(request, target);
  if (!other || !other->refusal) return true;
  const Refusal& objection = *other->refusal;
  return objection.of == Refusal::Of::kOutput || objection.place > refusal.place;
}

// Whether a target takes the whole shader; of a stage that it has one: there is little to say of the rest.
bool takes(const Request& request, const Target& target, const Refusal& refusal) {
  if (refusal.of == Refusal::Of::kStage) return has_stage(target, request.stage);
  const Result<Attempt> other = attempt(request, target);
  return other && !other->refusal;
}

// Whether the target is why: what neither of the two that have most takes is a mistake.
bool is_lack(const Request& request, const Target& target, const Refusal& refusal) {
  constexpr std::array kRichest = {"glsl450", "vulkan"};
  return refusal.of != Refusal::Of::kText || std::ranges::any_of(kRichest, [&](const char* name) {
           return target.name != name && gets_further(request, *find_target(name), refusal);
         });
}

}  // namespace

std::string join(const std::vector<std::string>& names) {
  if (names.empty()) return "no target";
  std::string text = names.front();
  for (size_t i = 1; i < names.size(); ++i) text += (i + 1 == names.size() ? " and " : ", ") + names[i];
  return text;
}

Diagnostic unknown_target(const std::string& name) {
  std::vector<std::string> known;
  for (const Target& target : targets()) known.push_back(target.name);
  return {.message = "unknown target \"" + name + "\": known are " + join(known)};
}

Diagnostic explain(const Request& request, const Target& target, const Refusal& refusal) {
  if (!is_lack(request, target, refusal)) return refusal.diagnostic;
  std::vector<std::string> others;
  for (const Target& other : targets()) {
    const bool is_other = other.name != target.name && other.format != Format::kHeader;
    if (is_other && takes(request, other, refusal)) others.push_back(other.name);
  }
  Diagnostic explained = refusal.diagnostic;
  if (!refusal.lacking.empty()) explained.message = refusal.lacking;
  explained.message += "; refused for the target " + target.name;
  if (!others.empty()) explained.message += ", taken by " + join(others);
  return explained;
}

}  // namespace gnomon::compiler
