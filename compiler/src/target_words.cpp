// SPDX-License-Identifier: MIT
#include "target_words.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>

#include "tokens.h"

namespace gnomon::compiler {
namespace {

constexpr int kNever = 1000;

// Since which versions there is a word; what is Vulkan's alone no version has.
struct Word {
  std::string_view word;  // ending in '*': any that begins so
  std::string_view what;
  int glsl;
  int essl;
  bool is_vulkans = false;
};

// The GLSL specification 4.60 and that of ESSL 3.20 in "Keywords"; GL_KHR_vulkan_glsl.
constexpr auto kWords = std::to_array<Word>({
    {"buffer", "storage blocks", 430, 310},
    {"shared", "shared variables", 430, 310},
    {"double", "doubles", 400, kNever},
    {"dvec*", "doubles", 400, kNever},
    {"dmat*", "doubles", 400, kNever},
    {"noperspective", "interpolation without perspective", 130, kNever},
    {"sample", "inputs by sample", 400, 320},
    {"precise", "`precise`", 400, 320},
    {"atomic_uint", "atomic counters", 420, 310},
    {"readonly", "storage blocks or images", 420, 310},
    {"writeonly", "storage blocks or images", 420, 310},
    {"coherent", "storage blocks or images", 420, 310},
    {"restrict", "storage blocks or images", 420, 310},
    {"volatile", "storage blocks or images", 420, 310},
    {"samplerBuffer", "texture buffers", 140, 320},
    {"isamplerBuffer", "texture buffers", 140, 320},
    {"usamplerBuffer", "texture buffers", 140, 320},
    {"imageBuffer", "image buffers", 420, 320},
    {"iimageBuffer", "image buffers", 420, 320},
    {"uimageBuffer", "image buffers", 420, 320},
    {"samplerCubeArray*", "arrays of cube maps", 400, 320},
    {"isamplerCubeArray", "arrays of cube maps", 400, 320},
    {"usamplerCubeArray", "arrays of cube maps", 400, 320},
    {"sampler2DMSArray", "arrays of multisampled textures", 150, 320},
    {"isampler2DMSArray", "arrays of multisampled textures", 150, 320},
    {"usampler2DMSArray", "arrays of multisampled textures", 150, 320},
    {"sampler2DMS", "multisampled textures", 150, 310},
    {"isampler2DMS", "multisampled textures", 150, 310},
    {"usampler2DMS", "multisampled textures", 150, 310},
    {"sampler2DRect*", "rectangle textures", 140, kNever},
    {"isampler2DRect", "rectangle textures", 140, kNever},
    {"usampler2DRect", "rectangle textures", 140, kNever},
    {"sampler1D*", "one-dimensional textures", 110, kNever},
    {"isampler1D*", "one-dimensional textures", 130, kNever},
    {"usampler1D*", "one-dimensional textures", 130, kNever},
    {"image1D*", "one-dimensional images", 420, kNever},
    {"iimage1D*", "one-dimensional images", 420, kNever},
    {"uimage1D*", "one-dimensional images", 420, kNever},
    {"image2DMS*", "multisampled images", 420, kNever},
    {"image2D*", "images", 420, 310},
    {"image3D", "images", 420, 310},
    {"imageCube", "images", 420, 310},
    {"iimage2D*", "images", 420, 310},
    {"iimage3D", "images", 420, 310},
    {"iimageCube", "images", 420, 310},
    {"uimage2D*", "images", 420, 310},
    {"uimage3D", "images", 420, 310},
    {"uimageCube", "images", 420, 310},
    {"sampler", "samplers apart from textures", kNever, kNever, true},
    {"samplerShadow", "samplers apart from textures", kNever, kNever, true},
    {"texture1D*", "textures apart from samplers", kNever, kNever, true},
    {"texture2D*", "textures apart from samplers", kNever, kNever, true},
    {"texture3D", "textures apart from samplers", kNever, kNever, true},
    {"textureCube*", "textures apart from samplers", kNever, kNever, true},
    {"textureBuffer", "textures apart from samplers", kNever, kNever, true},
    {"itexture*", "textures apart from samplers", kNever, kNever, true},
    {"utexture*", "textures apart from samplers", kNever, kNever, true},
    {"subpassInput*", "input attachments", kNever, kNever, true},
    {"isubpassInput*", "input attachments", kNever, kNever, true},
    {"usubpassInput*", "input attachments", kNever, kNever, true},
});

const Word* find(std::string_view word) {
  const auto matches = [&](const Word& row) {
    return row.word.ends_with('*') ? word.starts_with(row.word.substr(0, row.word.size() - 1))
                                   : word == row.word;
  };
  const auto* const row = std::ranges::find_if(kWords, matches);
  return row == kWords.end() ? nullptr : row;
}

bool has(const Target& target, const Word& word) {
  if (word.is_vulkans) return target.rules == Rules::kVulkan;
  const std::string_view line = target.version_line;
  const size_t digits = std::min(line.find_first_of("0123456789"), line.size());
  int version = 0;
  std::from_chars(line.data() + digits, line.data() + line.size(), version);
  return version >= (line.ends_with(" es") ? word.essl : word.glsl);
}

}  // namespace

std::optional<std::string> lacking_word(std::string_view line, const Target& target) {
  // Of several the first of the table: `buffer` before the `readonly` that it brings with it.
  const Word* lacking = nullptr;
  std::string_view word;
  for (const Token& token : tokenize(line)) {
    const Word* const row = find(token.text);
    if (row == nullptr || has(target, *row) || (lacking != nullptr && lacking <= row)) continue;
    lacking = row;
    word = token.text;
  }
  if (lacking == nullptr) return std::nullopt;
  return fmt::format("'{}': the target has no {}", word, lacking->what);
}

}  // namespace gnomon::compiler
