// SPDX-License-Identifier: MIT
// summary: The words in which one source text is GLSL and C++.
// source:  docs/architecture.md, "GLSL that is also C++"
// host:    none
// options: none
#ifndef GNOMON_CORE_PORTABLE_GLSL
#define GNOMON_CORE_PORTABLE_GLSL

// A second result of a function: GNOMON_OUT(float) name. C++ has no `out`, so it takes a reference there.
#ifdef __cplusplus
#define GNOMON_OUT(type) type&
#else
#define GNOMON_OUT(type) out type
#endif

#endif
