// SPDX-License-Identifier: MIT
#include "gl/choice.h"

#include <algorithm>
#include <cctype>
#include <optional>

namespace gnomon::gl {
namespace {

/// Lower is preferred. The surfaceless platform is Mesa's own choice, mostly its software renderer.
int rank(const Device& device) {
  if (device.api == Api::kOsmesa) return 3;
  if (device.egl_device == Device::kSurfaceless) return 1;
  return device.software.value_or(false) ? 2 : 0;
}

bool is_number(const std::string& text) {
  return !text.empty() && std::all_of(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; });
}

std::string lower(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return std::tolower(c); });
  return text;
}

bool contains(const std::string& text, const std::string& part) {
  return lower(text).find(lower(part)) != std::string::npos;
}

bool fits(const Found& found, std::size_t i, const Request& request) {
  const Device& device = found.devices[i];
  if (request.api && *request.api != device.api) return false;
  if (request.device.empty()) return true;
  if (is_number(request.device)) return request.device == std::to_string(i);
  return contains(device.renderer, request.device) || contains(device.place, request.device);
}

bool is_any(const Found& found, int of_rank) {
  return std::any_of(found.devices.begin(), found.devices.end(),
                     [&](const Device& device) { return rank(device) == of_rank; });
}

/// "no hardware EGL device was found", "no EGL device of a GPU works": why a rank was passed over.
std::string passed_over(const Found& found, int of_rank, const std::string& what) {
  return "no " + what + (is_any(found, of_rank) ? " works" : " was found");
}

std::string reason_of_order(const Found& found, const Device& device) {
  const std::string no_hardware = passed_over(found, 0, "hardware EGL device");
  switch (rank(device)) {
    case 0:
      return "it is the first hardware EGL device that works; hardware comes before software";
    case 1:
      return no_hardware + (device.software.value_or(true)
                                ? "; of software by EGL, the surfaceless platform comes first"
                                : "; the surfaceless platform comes next, and reaches hardware");
    case 2:
      return no_hardware + "; " + passed_over(found, 1, "surfaceless platform") +
             "; software EGL devices come next";
    default:
      if (!found.egl_lacks.empty()) return "EGL offers no device; OSMesa comes last";
      return "no EGL device works; OSMesa comes last";
  }
}

std::string reason_of(const Found& found, const Request& request, std::size_t chosen) {
  const Device& device = found.devices[chosen];
  if (!request.device.empty()) return "'--device " + request.device + "' asks for it";
  const std::string order = reason_of_order(found, device);
  if (!request.api) return order;
  const std::string asked = std::string("'--backend ") + name_of(*request.api) + "' asks for it";
  return *request.api == Api::kOsmesa ? asked : asked + "; " + order;
}

std::string lacks(const Found& found, Api api) {
  return api == Api::kEgl ? found.egl_lacks : found.osmesa_lacks;
}

/// The devices of a back end, or all, a line each.
std::vector<std::string> lines_of(const Found& found, const std::optional<Api>& api) {
  std::vector<std::string> lines;
  for (std::size_t i = 0; i < found.devices.size(); ++i) {
    if (!api || found.devices[i].api == *api) lines.push_back("device " + describe(found, i));
  }
  for (const Api each : {Api::kEgl, Api::kOsmesa}) {
    if ((!api || each == *api) && !lacks(found, each).empty())
      lines.push_back(std::string(name_of(each)) + ": " + lacks(found, each));
  }
  return lines;
}

Diagnostic machine(std::string message, std::vector<std::string> notes) {
  return {.message = std::move(message), .failure = Failure::kMachine, .notes = std::move(notes)};
}

Diagnostic none(const Found& found, const Request& request) {
  const bool listed = std::any_of(found.devices.begin(), found.devices.end(), [&](const Device& device) {
    return !request.api || device.api == *request.api;
  });
  const std::string asked = request.api ? std::string("'--backend ") + name_of(*request.api) + "': " : "";
  if (!listed && request.api) return machine(asked + lacks(found, *request.api), {});
  if (listed && !request.device.empty()) {
    bool unfit = true;
    for (std::size_t i = 0; i < found.devices.size(); ++i) unfit = unfit && !fits(found, i, request);
    return machine(asked + "'--device " + request.device + "' " +
                       (unfit ? "matches none of the devices" : "gives no OpenGL context") + ", which are",
                   lines_of(found, request.api));
  }
  return machine(asked + "no OpenGL 4.5 context; '--method reference' and '--backend cpu' need none",
                 lines_of(found, request.api));
}

}  // namespace

const char* name_of(Api api) {
  return api == Api::kEgl ? "egl" : "osmesa";
}

bool asks_by_name(const Request& request) {
  return !request.device.empty() && !is_number(request.device);
}

std::string describe(const Found& found, std::size_t i) {
  const Device& device = found.devices[i];
  std::string text = std::to_string(i) + " " + name_of(device.api) + ": ";
  if (!device.renderer.empty()) text += device.renderer + ", ";
  if (device.software) text += *device.software ? "software, " : "hardware, ";
  text += device.place;
  if (!device.failure.empty()) text += "; gives no context: " + device.failure;
  return text;
}

Result<Choice> choose(const Found& found, const Request& request) {
  std::optional<std::size_t> best;
  for (std::size_t i = 0; i < found.devices.size(); ++i) {
    if (!found.devices[i].failure.empty() || !fits(found, i, request)) continue;
    if (!best || rank(found.devices[i]) < rank(found.devices[*best])) best = i;
  }
  if (!best) return none(found, request);
  return Choice{*best, reason_of(found, request, *best)};
}

}  // namespace gnomon::gl
