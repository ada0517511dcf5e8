// SPDX-License-Identifier: MIT
#include "scene/validate.h"

#include <nlohmann/json.hpp>
#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validation_results.hpp>
#include <valijson/validator.hpp>

namespace gnomon::scene {

std::vector<ShapeFailure> validate(const std::string& schema, const std::string& value) {
  using Adapter = valijson::adapters::NlohmannJsonAdapter;
  const nlohmann::json schema_json = nlohmann::json::parse(schema), value_json = nlohmann::json::parse(value);
  valijson::Schema compiled;
  valijson::SchemaParser(valijson::SchemaParser::kDraft7).populateSchema(Adapter(schema_json), compiled);
  valijson::ValidationResults results;
  valijson::Validator(valijson::Validator::kStrongTypes).validate(compiled, Adapter(value_json), &results);

  std::vector<ShapeFailure> failures;
  for (const valijson::ValidationResults::Error& error : results) {
    if (error.description.starts_with("Failed to validate"))
      continue;  // a value inside this one, reported itself
    ShapeFailure failure{{}, error.description};
    for (auto part = error.context.begin() + 1; part != error.context.end();
         ++part) {  // "<root>", "[key]", "[0]"
      failure.path.push_back(part->substr(1, part->size() - 2));
    }
    failures.push_back(std::move(failure));
  }
  return failures;
}

}  // namespace gnomon::scene
