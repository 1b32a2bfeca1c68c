/// @file
/// @brief The best instruction set of the machine, chosen when the library is loaded.
///
/// The library is built for any processor of its kind. The few loops that most of the time goes into are compiled
/// several times on x86-64, and the dynamic linker takes the version that the processor can run: before the thread
/// sanitizer is ready, which cannot have it.
#pragma once

#include <cstddef>  // defines __GLIBC__ where the C library has it

#if defined(__x86_64__) && defined(__GLIBC__) && defined(__GNUC__) && !defined(__clang__) && \
    !defined(__SANITIZE_THREAD__)
#define VISCOROLL_BEST_INSTRUCTIONS __attribute__((target_clones("default", "arch=x86-64-v3", "arch=x86-64-v4")))
#else
#define VISCOROLL_BEST_INSTRUCTIONS
#endif

/// What is to be compiled as part of each such version, not once for all of them.
#if defined(__GNUC__)
#define VISCOROLL_PART_OF_CALLER __attribute__((always_inline)) inline
#else
#define VISCOROLL_PART_OF_CALLER inline
#endif
