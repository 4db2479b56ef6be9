// One function compiled for several instruction sets, chosen when the program starts.
#pragma once

/// Put before a function whose result does not depend on the instruction set: no reassociated sums, no fused
/// multiply-add (the build forbids both). Sanitizers instrument the code that chooses, before they are up:
/// not with them.
#if defined(__GNUC__) && !defined(__clang__) && defined(__x86_64__) && defined(__linux__) && \
    !defined(__SANITIZE_THREAD__) && !defined(__SANITIZE_ADDRESS__)
#define LODESTONE_VECTOR_CLONES __attribute__((target_clones("avx2", "default")))
#else
#define LODESTONE_VECTOR_CLONES
#endif
