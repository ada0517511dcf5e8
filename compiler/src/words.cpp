// SPDX-License-Identifier: MIT
#include "words.h"

#include <array>
#include <span>

namespace gnomon::compiler {
namespace {

// Blanks at both ends, so that " word " is found as a whole. What GLSL reserves too is left out.

// Microsoft's "Keywords", "Reserved words" and "Intrinsic functions" of HLSL.
constexpr std::string_view kHlslWords =
    " AppendStructuredBuffer BlendState Buffer ByteAddressBuffer CompileShader ComputeShader "
    "ConsumeStructuredBuffer DepthStencilState DepthStencilView DomainShader GeometryShader Hullshader "
    "InputPatch LineStream OutputPatch PixelShader PointStream RWBuffer RWByteAddressBuffer "
    "RWStructuredBuffer RWTexture1D RWTexture1DArray RWTexture2D RWTexture2DArray RWTexture3D "
    "RasterizerState RenderTargetView SamplerComparisonState SamplerState StructuredBuffer Texture1D "
    "Texture1DArray Texture2D Texture2DArray Texture2DMS Texture2DMSArray Texture3D TextureCube "
    "TextureCubeArray TriangleStream VertexShader abort "
    "AllMemoryBarrier AllMemoryBarrierWithGroupSync DeviceMemoryBarrier DeviceMemoryBarrierWithGroupSync "
    "GroupMemoryBarrier GroupMemoryBarrierWithGroupSync InterlockedAdd InterlockedAnd "
    "InterlockedCompareExchange InterlockedCompareStore InterlockedExchange InterlockedMax InterlockedMin "
    "InterlockedOr InterlockedXor CheckAccessFullyMapped EvaluateAttributeAtSample EvaluateAttributeCentroid "
    "EvaluateAttributeSnapped GetRenderTargetSampleCount GetRenderTargetSamplePosition "
    "asdouble asfloat asint asuint asm_fragment atan2 auto catch cbuffer char clip column_major compile "
    "compile_fragment const_cast countbits ddx ddx_coarse ddx_fine ddy ddy_coarse ddy_fine delete dst "
    "dynamic_cast errorf explicit export f16tof32 f32tof16 firstbithigh firstbitlow fmod frac friend "
    "fxgroup globallycoherent groupshared isfinite lerp line lineadj linear log10 mad matrix msad4 mul "
    "mutable new nointerpolation operator pass pixelfragment point printf private protected rcp "
    "register reinterpret_cast reversebits row_major rsqrt saturate sampler_state signed sincos "
    "sizeof snorm stateblock stateblock_state static_cast string tbuffer technique technique10 technique11 "
    "tex1D tex1Dbias tex1Dgrad tex1Dlod tex1Dproj tex2D tex2Dbias tex2Dgrad tex2Dlod tex2Dproj tex3D "
    "tex3Dbias tex3Dgrad tex3Dlod tex3Dproj texCUBE texCUBEbias texCUBEgrad texCUBElod texCUBEproj texture "
    "Texture throw triangle triangleadj try typename unorm unsigned vector vertexfragment "
    "virtual dword NULL ";

// Of C++14 and the Metal shading language specification 2.1.
constexpr std::string_view kMslWords =
    " alignas alignof and and_eq auto bitand bitor catch char char16_t char32_t compl const_cast constexpr "
    "decltype delete dynamic_cast explicit export friend mutable new noexcept not not_eq nullptr operator or "
    "or_eq private protected register reinterpret_cast signed sizeof static_assert static_cast thread_local "
    "throw try typeid typename virtual wchar_t xor xor_eq unsigned "
    "metal std kernel vertex fragment constant device thread threadgroup threadgroup_imageblock imageblock "
    "access array array_ref atomic atomic_bool atomic_int atomic_uint atomic_float bias bool2 bool3 bool4 "
    "patch ptrdiff_t size_t sampler depth2d depth2d_array depth2d_ms depthcube depthcube_array gradient2d "
    "gradient3d gradientcube level min_lod_clamp level component texture texture1d texture1d_array texture2d "
    "texture2d_array texture2d_ms texture2d_ms_array texture3d texturecube texturecube_array texture_buffer "
    "vec matrix packed int8_t int16_t int32_t int64_t uint8_t uint16_t uint32_t uint64_t uchar ushort ulong "
    "as_type assert absdiff addsat atan2 clz copysign cospi ctz dfdx dfdy divide "
    "discard_fragment exp10 extract_bits fabs fast fdim fmax fmax3 fmedian3 fmin fmin3 fmod "
    "get_num_samples get_sample_position hadd ilogb insert_bits isfinite isnormal isordered "
    "isunordered length_squared distance_squared log10 logb mad24 madhi madsat max3 median3 memory_order "
    "mem_flags memory_order_relaxed min3 mulhi nan nextafter popcount powr precise "
    "quad_broadcast reverse_bits rhadd rint rotate rsqrt saturate select signbit sincos sinpi subsat tanpi "
    "threadgroup_barrier simdgroup_barrier atomic_load_explicit atomic_store_explicit "
    "atomic_fetch_add_explicit atomic_exchange_explicit INFINITY NAN HUGE_VALF MAXFLOAT M_PI_F M_E_F M_PI_H "
    "FLT_MAX FLT_MIN FLT_EPSILON INT_MAX INT_MIN UINT_MAX NULL TRUE FALSE ";

bool has_word(std::string_view words, std::string_view name) {
  for (size_t at = words.find(name); at != words.npos; at = words.find(name, at + 1)) {
    if (at > 0 && words[at - 1] == ' ' && words[at + name.size()] == ' ') return true;
  }
  return false;
}

// "float4", "packed_half3", "min16float3x4"
bool is_numeric_type(Format format, std::string_view name) {
  constexpr std::array<std::string_view, 12> hlsl = {"min16float", "min10float", "min16int", "min12int",
                                                     "min16uint",  "float",      "double",   "half",
                                                     "bool",       "int",        "uint",     "dword"};
  constexpr std::array<std::string_view, 11> msl = {"float",  "half", "bool",  "int",  "uint", "short",
                                                    "ushort", "char", "uchar", "long", "ulong"};
  if (format == Format::kMsl && name.starts_with("packed_")) name.remove_prefix(7);
  const auto is_size = [](char c) { return c >= '1' && c <= '4'; };
  const std::span<const std::string_view> scalars =
      format == Format::kHlsl ? std::span<const std::string_view>(hlsl) : msl;
  for (const std::string_view scalar : scalars) {
    if (!name.starts_with(scalar)) continue;
    const std::string_view size = name.substr(scalar.size());
    if (size.empty() || (size.size() == 1 && is_size(size[0])) ||
        (size.size() == 3 && is_size(size[0]) && size[1] == 'x' && is_size(size[2])))
      return true;
  }
  return false;
}

}  // namespace

bool is_word_of(Format format, std::string_view name) {
  if (name.empty() || name.find(' ') != name.npos) return false;
  if (format == Format::kHlsl) return is_numeric_type(format, name) || has_word(kHlslWords, name);
  return format == Format::kMsl && (is_numeric_type(format, name) || has_word(kMslWords, name));
}

}  // namespace gnomon::compiler
