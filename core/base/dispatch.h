#pragma once

// Functions marked VYBEG_DISPATCHED are compiled for these processors, the best of which is chosen
// when the program starts: any x86-64, AVX2 with FMA, and AVX-512. What they call is compiled with
// them only where it is VYBEG_INLINED. Not under AddressSanitizer or ThreadSanitizer: the choice
// would come before they are ready.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && \
    !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define VYBEG_TARGETS(...) __attribute__((target_clones(__VA_ARGS__)))
#else
#define VYBEG_TARGETS(...)
#endif
#define VYBEG_DISPATCHED VYBEG_TARGETS("arch=x86-64-v4", "arch=x86-64-v3", "default")
#define VYBEG_INLINED __attribute__((always_inline))
