// SPDX-License-Identifier: MIT
#include <nlohmann/json.hpp>

#include "gnomon/compiler/reflection.h"

namespace gnomon::compiler {
namespace {

using Json = nlohmann::ordered_json;

void put(Json& json, const char* key, const std::optional<int>& value) {
  if (value) json[key] = *value;
}

void put_array(Json& json, int size) {
  if (size > 0) json["array_size"] = size;
}

Json of(const Variable& variable) {
  Json json = {{"name", variable.name}, {"type", variable.type}};
  put_array(json, variable.array_size);
  put(json, "location", variable.location);
  put(json, "set", variable.set);
  put(json, "binding", variable.binding);
  put(json, "input_attachment_index", variable.input_attachment_index);
  return json;
}

Json of(const Member& member) {
  Json json = {{"name", member.name}, {"type", member.type}};
  put(json, "offset", member.offset);
  put_array(json, member.array_size);
  put(json, "array_stride", member.array_stride);
  put(json, "matrix_stride", member.matrix_stride);
  if (member.is_row_major) json["row_major"] = true;
  return json;
}

Json of(const SpecializationConstant& constant) {
  return {{"name", constant.name}, {"type", constant.type}, {"id", constant.id}};
}

Json of(const Block& block);

Json of(const HostFunction& function) {
  return {{"name", function.name}, {"file", function.file}};
}

Json of(const OptionValue& option) {
  return {{"name", option.name}, {"value", option.value}, {"default", option.default_value}};
}

template <class T>
Json list_of(const std::vector<T>& items) {
  Json list = Json::array();
  for (const T& item : items) list.push_back(of(item));
  return list;
}

Json of(const Block& block) {
  Json json = {{"name", block.name}, {"kind", kind_name(block.kind)}};
  if (block.is_readonly) json["readonly"] = true;
  put_array(json, block.array_size);
  put(json, "size", block.size);
  put(json, "set", block.set);
  put(json, "binding", block.binding);
  json["members"] = list_of(block.members);
  return json;
}

}  // namespace

std::string_view kind_name(BlockKind kind) {
  switch (kind) {
    case BlockKind::kStorage:
      return "storage";
    case BlockKind::kPushConstant:
      return "push_constant";
    case BlockKind::kUniform:
      break;
  }
  return "uniform";
}

std::string to_json(const Reflection& reflection) {
  Json json = {{"version", 1}, {"target", reflection.target}};
  // One stage a file; a list, so that files of several stages can be told apart later without another schema.
  json["stages"] = {stage_name(reflection.stage).title};
  json["inputs"] = list_of(reflection.inputs);
  json["outputs"] = list_of(reflection.outputs);
  json["uniforms"] = list_of(reflection.uniforms);
  json["textures"] = list_of(reflection.textures);
  json["blocks"] = list_of(reflection.blocks);
  if (!reflection.constants.empty()) json["constants"] = list_of(reflection.constants);
  json["host_functions"] = list_of(reflection.host_functions);
  json["options"] = list_of(reflection.options);
  if (!reflection.local_size.empty()) json["local_size"] = reflection.local_size;
  if (reflection.spirv_size) json["spirv_size"] = *reflection.spirv_size;
  return json.dump(2) + "\n";
}

}  // namespace gnomon::compiler
