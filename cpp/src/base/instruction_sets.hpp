/// @file
/// @brief Selection of the best instruction set of the machine when the library is loaded.
///
/// The library is built for every processor of its architecture. The few loops that take most of the time are compiled
/// several times on x86-64, and the dynamic linker selects the version that the processor can run. The linker does so
/// before the thread sanitizer is initialized, so that builds with this sanitizer have a single version.
#pragma once

#include <cstddef>  // defines __GLIBC__ where the C library has it

#if defined(__x86_64__) && defined(__GLIBC__) && defined(__GNUC__) && !defined(__clang__) && \
    !defined(__SANITIZE_THREAD__)
#define VISCOROLL_BEST_INSTRUCTIONS __attribute__((target_clones("default", "arch=x86-64-v3", "arch=x86-64-v4")))
#else
#define VISCOROLL_BEST_INSTRUCTIONS
#endif

/// Marks a function that is compiled as part of each such version rather than once for all of them.
#if defined(__GNUC__)
#define VISCOROLL_PART_OF_CALLER __attribute__((always_inline)) inline
#else
#define VISCOROLL_PART_OF_CALLER inline
#endif
