// SPDX-License-Identifier: MIT
#include "entry_point.h"

#include <fmt/format.h>

#include <string_view>

#include "prototype.h"

namespace gnomon::compiler {
namespace {

// What a stage needs besides, and the statement that makes its result depend on gnomon_check_sum.
struct StageFrame {
  std::string_view declarations;
  std::string_view output;
};

StageFrame frame_of(Stage stage) {
  switch (stage) {
    case Stage::kVertex:
      return {"", "gl_Position = vec4(gnomon_check_sum);"};
    case Stage::kGeometry:
      return {"layout(points) in; layout(points, max_vertices = 1) out;",
              "gl_Position = vec4(gnomon_check_sum); EmitVertex();"};
    case Stage::kCompute:
      return {
          "layout(local_size_x = 1) in; layout(std430) buffer gnomon_check_buffer { float "
          "gnomon_check_result; };",
          "gnomon_check_result = gnomon_check_sum;"};
    case Stage::kFragment:
      break;
  }
  // A built-in output clashes with none that the module declares.
  return {"", "gl_FragDepth = gnomon_check_sum;"};
}

std::string_view spell(Passing passing) {
  switch (passing) {
    case Passing::kConstIn:
      return "const in ";
    case Passing::kOut:
      return "out ";
    case Passing::kInOut:
      return "inout ";
    case Passing::kIn:
      break;
  }
  return "in ";
}

bool is_written(const Parameter& parameter) {
  return parameter.passing == Passing::kOut || parameter.passing == Passing::kInOut;
}

bool is_opaque(const Parameter& parameter) {
  return parameter.type.kind == Type::Kind::kOpaque;
}

std::string argument_name(size_t i) {
  return fmt::format("gnomon_check_{}", i);
}

// " + float(name.x) + ..." over every scalar of a value.
std::string sum_of(const Type& type, const std::string& name) {
  if (type.kind == Type::Kind::kScalar) return fmt::format(" + float({})", name);
  std::string sum;
  if (type.kind != Type::Kind::kComposite) return sum;
  for (const Type::Part& part : type.parts) sum += sum_of(part.type, name + part.accessor);
  return sum;
}

class EntryPoint {
 public:
  explicit EntryPoint(Assembled& module) : module_(module) {}

  void append(const Shader& shader, Stage stage) {
    const StageFrame frame = frame_of(stage);
    const LineOrigin origin{0, 1};
    emit("uniform float gnomon_check_input; float gnomon_check_sum;", origin);
    if (!frame.declarations.empty()) emit(frame.declarations, origin);
    const std::string text = module_.text;
    for (const Function& function : shader.undefined) {
      const int prototype = line_of_prototype(text, function.name);
      define(function, origin_of(prototype > 0 ? prototype : function.line));
    }
    for (const Function& function : shader.defined) declare_opaque(function);
    emit("void main() { gnomon_check_sum = 0.0;", origin);
    for (const Function& function : shader.defined) call(function);
    emit(std::string(frame.output) + " }", origin);
  }

 private:
  [[nodiscard]] LineOrigin origin_of(int line) const {
    return module_.origins[static_cast<size_t>(line - 1)];
  }

  void emit(std::string_view line, LineOrigin origin) {
    module_.text += line;
    module_.text += '\n';
    module_.origins.push_back(origin);
  }

  // Statements that give every scalar of a variable a value that no compiler can know, each another: equal
  // ones would cancel in the function.
  std::string assign(const Type& type, const std::string& name, std::string_view seed) {
    if (type.kind == Type::Kind::kScalar)
      return fmt::format("{} = {}({} + {}.0); ", name, type.name, seed, ++values_);
    std::string statements;
    for (const Type::Part& part : type.parts) statements += assign(part.type, name + part.accessor, seed);
    return statements;
  }

  // A host function whose result depends on everything that it is given.
  void define(const Function& function, LineOrigin origin) {
    constexpr std::string_view seed = "gnomon_check_sum";
    std::string parameters;
    std::string given;
    std::string written;
    for (size_t i = 0; i < function.parameters.size(); ++i) {
      const auto& [type, passing] = function.parameters[i];
      const std::string name = argument_name(i);
      parameters += fmt::format("{}{}{} {}", i == 0 ? "" : ", ", spell(passing), type.name, name);
      if (passing != Passing::kOut) given += sum_of(type, name);
      if (is_written(function.parameters[i])) written += assign(type, name, seed);
    }
    if (function.result.kind != Type::Kind::kVoid) {
      const std::string result = "gnomon_check_returned";
      written += fmt::format("{} {}; {}return {};", function.result.name, result,
                             assign(function.result, result, seed), result);
    }
    emit(fmt::format("{} {}({}) {{ {} += gnomon_check_input{}; {} }}", function.result.name, function.name,
                     parameters, seed, given, written),
         origin);
  }

  std::string opaque_name(const Function& function, size_t parameter) {
    return fmt::format("gnomon_check_{}_{}", function.line, parameter);
  }

  // A parameter has no format, so that glslang takes for it only what is writeonly. In ESSL a uniform image
  // has to have one all the same; in SPIR-V it would be another type.
  [[nodiscard]] std::string_view image_qualifiers(std::string_view type) const {
    const bool is_image =
        type.starts_with("image") || type.starts_with("iimage") || type.starts_with("uimage");
    if (!is_image) return "";
    if (!std::string_view(module_.text).substr(0, module_.text.find('\n')).ends_with(" es"))
      return "writeonly ";
    if (type.starts_with("image")) return "layout(r32f) writeonly ";
    return type.starts_with("iimage") ? "layout(r32i) writeonly " : "layout(r32ui) writeonly ";
  }

  void declare_opaque(const Function& function) {
    for (size_t i = 0; i < function.parameters.size(); ++i) {
      if (!is_opaque(function.parameters[i])) continue;
      const std::string& type = function.parameters[i].type.name;
      emit(fmt::format("{}uniform {} {};", image_qualifiers(type), type, opaque_name(function, i)),
           origin_of(function.line));
    }
  }

  void call(const Function& function) {
    std::string variables;
    std::string arguments;
    std::string results;
    for (size_t i = 0; i < function.parameters.size(); ++i) {
      const Parameter& parameter = function.parameters[i];
      const std::string name = is_opaque(parameter) ? opaque_name(function, i) : argument_name(i);
      if (!is_opaque(parameter)) {
        variables += fmt::format("{} {}; {}", parameter.type.name, name,
                                 assign(parameter.type, name, "gnomon_check_input"));
      }
      if (is_written(parameter)) results += sum_of(parameter.type, name);
      arguments += fmt::format("{}{}", i == 0 ? "" : ", ", name);
    }
    results += sum_of(function.result, "gnomon_check_returned");
    const bool returns = function.result.kind != Type::Kind::kVoid;
    const std::string taken = returns ? function.result.name + " gnomon_check_returned = " : "";
    emit(fmt::format("{{ {}{}{}({}); gnomon_check_sum += 0.0{}; }}", variables, taken, function.name,
                     arguments, results),
         origin_of(function.line));
  }

  Assembled& module_;
  int values_ = 0;
};

}  // namespace

void append_entry_point(Assembled& module, const Shader& shader, Stage stage) {
  EntryPoint(module).append(shader, stage);
}

}  // namespace gnomon::compiler
