// SPDX-License-Identifier: MIT
#include "testing/defined_functions.h"

#include "gnomon/compiler/compiler.h"
#include "gnomon/compiler/modules.h"
#include "shader.h"

namespace gnomon::modules {

Result<std::vector<DefinedFunction>> defined_functions(const std::string& library) {
  const auto modules = compiler::list_modules(library);
  if (!modules) return modules.diagnostics();
  std::vector<DefinedFunction> functions;
  for (const compiler::Module& module : *modules) {
    if (module.defines_host()) continue;
    const compiler::Options options{.library_directory = library};
    const auto assembled = compiler::assemble(module.path, options);
    if (!assembled) return assembled.diagnostics();
    const compiler::Shader shader = compiler::compile(assembled->text, compiler::Stage::kFragment,
                                                      *compiler::find_target(options.target));
    if (shader.error) return compiler::locate(*assembled, shader.error->line, shader.error->text);
    for (const compiler::Function& function : shader.defined) {
      const bool is_its_own = assembled->origins[static_cast<std::size_t>(function.line - 1)].inclusion == 0;
      if (is_its_own) functions.push_back({module.name, function.name});
    }
  }
  return functions;
}

}  // namespace gnomon::modules
