// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <kainjow/mustache.hpp>
#include <span>
#include <system_error>
#include <utility>

#include "gnomon/atomic_file.h"
#include "report/page_template.h"
#include "report/picture_link.h"
#include "report/report.h"

namespace gnomon::report {
namespace {

using kainjow::mustache::data;
using kainjow::mustache::list;
using kainjow::mustache::mustache;

/// Which of the page's three sections a test belongs to; also its style.
std::string kind_of(Status status) {
  if (status == Status::kPassed || status == Status::kSkipped) return status_text(status);
  return "failed";
}

/// An empty text would count as present in a template.
void set_text(data& view, const std::string& key, const std::string& text) {
  text.empty() ? view.set(key, false) : view.set(key, text);
}

data verdict_data(const judge::Verdict& verdict) {
  data view;
  view["passed"] = verdict.passed;
  view["expectation"] = verdict.expectation;
  view["measured"] = verdict.measured;
  view["limit"] = verdict.limit;
  set_text(view, "worst", verdict.worst ? worst_pixel_text(*verdict.worst) : "");
  return view;
}

data picture_data(const std::string& name, const std::string& png, const std::string& exr,
                  const std::string& directory) {
  data view;
  view["name"] = name;
  view["legend"] = name == "Difference";
  set_text(view, "data", exr.empty() ? "" : link_to(exr, directory));
  view["source"] = false;
  if (const auto size = shown_size(png)) {
    view["source"] = link_to(png, directory);
    view["width"] = std::to_string(size->width);
    view["height"] = std::to_string(size->height);
    view["small"] = size->enlarged_pixels;
  }
  return view;
}

list pictures_of(const TestResult& result, const std::string& directory) {
  list pictures;
  if (result.expected_png.empty() && result.actual_png.empty() && result.difference_png.empty())
    return pictures;
  pictures.push_back(picture_data("Expected", result.expected_png, result.expected_exr, directory));
  pictures.push_back(picture_data("Actual", result.actual_png, result.actual_exr, directory));
  if (!result.difference_png.empty()) {
    pictures.push_back(picture_data("Difference", result.difference_png, "", directory));
  }
  return pictures;
}

list commands_of(const TestResult& result) {
  list commands;
  for (const auto& [name, command] : {std::pair{"Reproduce", result.reproduce}, {"Accept", result.accept}}) {
    if (command.empty()) continue;
    data view;
    view["name"] = name;
    view["command"] = command;
    commands.push_back(view);
  }
  return commands;
}

/// A list under `key`, and under has_KEY whether there is anything in it.
void set_list(data& view, const std::string& key, const list& items) {
  view["has_" + key] = !items.empty();
  view.set(key, items);
}

data test_data(const TestResult& result, const std::string& directory) {
  data view;
  view["id"] = result.id;
  view["kind"] = kind_of(result.status);
  view["status"] = status_text(result.status);
  view["open"] = kind_of(result.status) == "failed";
  set_text(view, "note", result.golden_note);
  set_text(view, "description", result.description);
  set_text(view, "error", result.error);
  set_text(view, "scene_file", result.scene_file);
  list verdicts;
  for (const judge::Verdict& verdict : result.verdicts) verdicts.push_back(verdict_data(verdict));
  set_list(view, "verdicts", verdicts);
  set_list(view, "pictures", pictures_of(result, directory));
  set_list(view, "commands", commands_of(result));
  return view;
}

/// Sections that hold a test, what needs attention first; each in the order of the results.
data page_data(const std::string& directory, const std::vector<TestResult>& results, const PageInfo& info) {
  data page;
  page["title"] = info.title;
  page["version"] = info.version;
  page["summary"] = summary_line(results);
  set_text(page, "renderer", info.renderer);
  list sections;
  list totals;
  for (const auto& [kind, heading] :
       {std::pair{"failed", "Failed"}, {"skipped", "Skipped"}, {"passed", "Passed"}}) {
    list tests;
    for (const TestResult& result : results) {
      if (kind_of(result.status) == kind) tests.push_back(test_data(result, directory));
    }
    if (tests.empty()) continue;
    data total;
    total["kind"] = kind;
    total["count"] = std::to_string(tests.size());
    totals.push_back(total);
    data section = total;
    section["heading"] = heading;
    section.set("tests", tests);
    sections.push_back(section);
  }
  page.set("totals", totals);
  page.set("sections", sections);
  return page;
}

}  // namespace

Result<Done> write_page(const std::string& directory, const std::vector<TestResult>& results,
                        const PageInfo& info) {
  std::error_code error;
  std::filesystem::create_directories(directory, error);
  if (error) {
    return Diagnostic{.file = directory,
                      .message = fmt::format("cannot make the folder of the report: {}", error.message()),
                      .failure = Failure::kMachine};
  }
  mustache page{std::string(page_template())};
  const std::string html = page.render(page_data(directory, results, info));
  return write_file_atomically((std::filesystem::path(directory) / "index.html").string(),
                               std::as_bytes(std::span(html)));
}

}  // namespace gnomon::report
