// SPDX-License-Identifier: MIT
// A function of the modules, callable with a list of scalars in C++ and described as GLSL.
#ifndef GNOMON_TESTING_MODULE_FUNCTION_H
#define GNOMON_TESTING_MODULE_FUNCTION_H

#include <functional>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include "testing/scalars.h"

namespace gnomon::modules {

struct ModuleFunction {
  std::string name;
  int arguments = 0;                 ///< scalars
  std::vector<bool> is_float;        ///< of each of them
  std::string glsl;                  ///< statements that call it with argument(0), argument(1) ...
  std::vector<std::string> results;  ///< GLSL expressions after them: the result, then second results
  std::function<std::vector<float>(const Modules&, std::span<const float>)> call;  ///< the same in C++
};

template <class P>
inline constexpr bool kIsSecondResult = std::is_lvalue_reference_v<P>;

/// The arguments that a function with these parameters is given: all but second results.
template <class... P>
using Given = decltype(std::tuple_cat(
    std::declval<std::conditional_t<kIsSecondResult<P>, std::tuple<>, std::tuple<P>>>()...));

/// What it answers: its result, where it has one, then the second results.
template <class R, class... P>
using Answer = decltype(std::tuple_cat(
    std::declval<std::conditional_t<std::is_void_v<R>, std::tuple<>, std::tuple<R>>>(),
    std::declval<
        std::conditional_t<kIsSecondResult<P>, std::tuple<std::remove_reference_t<P>>, std::tuple<>>>()...));

template <class... T>
[[nodiscard]] std::vector<float> scalars_of(const std::tuple<T...>& values) {
  std::vector<float> scalars;
  std::apply([&](const T&... value) { (append_scalars(value, scalars), ...); }, values);
  return scalars;
}

template <class Tuple>
[[nodiscard]] Tuple take_tuple(std::span<const float> scalars) {
  return [&]<std::size_t... I>(std::index_sequence<I...>) {
    return Tuple{take_scalars<std::tuple_element_t<I, Tuple>>(scalars)...};
  }
  (std::make_index_sequence<std::tuple_size_v<Tuple>>());
}

template <class R, class... P>
[[nodiscard]] std::vector<float> call_in_cpp(R (Modules::*function)(P...) const, const Modules& modules,
                                             std::span<const float> scalars) {
  const auto take = [&]<class Q>(std::type_identity<Q>) {
    if constexpr (kIsSecondResult<Q>)
      return std::remove_reference_t<Q>{};
    else
      return take_scalars<Q>(scalars);
  };
  std::tuple<std::remove_reference_t<P>...> all{take(std::type_identity<P>())...};
  std::vector<float> results;
  std::apply(
      [&](auto&... argument) {
        if constexpr (std::is_void_v<R>)
          (modules.*function)(argument...);
        else
          append_scalars((modules.*function)(argument...), results);
        const auto append = [&]<class Q>(std::type_identity<Q>, const auto& value) {
          if constexpr (kIsSecondResult<Q>) append_scalars(value, results);
        };
        (append(std::type_identity<P>(), argument), ...);
      },
      all);
  return results;
}

template <class R, class... P>
[[nodiscard]] ModuleFunction describe(std::string name, R (Modules::*function)(P...) const) {
  ModuleFunction described{.name = std::move(name), .is_float = {}, .glsl = {}, .results = {}, .call = {}};
  std::string arguments;
  std::vector<std::string> seconds;
  const auto pass = [&]<class Q>(std::type_identity<Q>) {
    using Value = std::remove_reference_t<Q>;
    const std::string variable =
        "given_" + std::to_string(seconds.size()) + "_" + std::to_string(described.arguments);
    described.glsl += "  " + glsl_name<Value>() + " " + variable;
    if constexpr (kIsSecondResult<Q>)
      append_glsl_scalars<Value>(variable, seconds);
    else {
      described.glsl += " = " + construct_in_glsl<Value>(described.arguments);
      Value value{};
      visit_scalars(value, [&](auto& scalar) {
        described.is_float.push_back(std::is_same_v<decltype(scalar), float&>);
      });
    }
    described.glsl += ";\n";
    arguments += (arguments.empty() ? "" : ", ") + variable;
  };
  (pass(std::type_identity<P>()), ...);
  const std::string call = described.name + "(" + arguments + ");\n";
  if constexpr (std::is_void_v<R>) {
    described.glsl += "  " + call;
  } else {
    described.glsl += "  " + glsl_name<R>() + " returned = " + call;
    append_glsl_scalars<R>("returned", described.results);
  }
  described.results.insert(described.results.end(), seconds.begin(), seconds.end());
  described.call = [function](const Modules& modules, std::span<const float> scalars) {
    return call_in_cpp(function, modules, scalars);
  };
  return described;
}

}  // namespace gnomon::modules

#endif
