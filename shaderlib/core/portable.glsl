// SPDX-License-Identifier: MIT
// summary: The words in which one source text is GLSL and C++, and what the dialect has.
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

// Before the prototype of a host function that only a few modules ask for: in C++ a host need not define it, and the
// program ends, naming it, where a module asks in vain.
#define GNOMON_OPTIONAL

// What the dialect has. __VERSION__ is a string in C++.
#if defined(__cplusplus)
#define GNOMON_HAS_STORAGE_BUFFER 0
#define GNOMON_HAS_TEXTURE_BUFFER 0
#define GNOMON_HAS_PRECISE 0
#elif defined(GL_ES)
#define GNOMON_HAS_STORAGE_BUFFER (__VERSION__ >= 310)
#define GNOMON_HAS_TEXTURE_BUFFER (__VERSION__ >= 320)
#define GNOMON_HAS_PRECISE (__VERSION__ >= 320)
#else
#define GNOMON_HAS_STORAGE_BUFFER (__VERSION__ >= 430)
#define GNOMON_HAS_TEXTURE_BUFFER (__VERSION__ >= 140)
#define GNOMON_HAS_PRECISE (__VERSION__ >= 400)
#endif

// Before a variable: its operations round one by one, none is fused or reordered.
#if GNOMON_HAS_PRECISE
#define GNOMON_PRECISE precise
#else
#define GNOMON_PRECISE
#endif

#endif
