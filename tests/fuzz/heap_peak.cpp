#include "tests/fuzz/heap_peak.h"

#include <atomic>
#include <cerrno>
#include <cstddef>

namespace {

std::atomic<std::int64_t> held{0};
std::atomic<std::int64_t> most{0};
std::int64_t at_start = 0;

void add(std::size_t bytes) {
    const std::int64_t now = held += static_cast<std::int64_t>(bytes);
    std::int64_t before = most.load();
    while (now > before && !most.compare_exchange_weak(before, now)) {
    }
}

void subtract(std::size_t bytes) {
    held -= static_cast<std::int64_t>(bytes);
}

}  // namespace

#ifdef __SANITIZE_ADDRESS__

// Of sanitizer/allocator_interface.h, which Debian's GCC does not bring.
extern "C" {
std::size_t __sanitizer_get_allocated_size(const volatile void* place);
int __sanitizer_install_malloc_and_free_hooks(void (*allocated)(const volatile void*, std::size_t),
                                              void (*freed)(const volatile void*));
}

namespace {

void allocated(const volatile void*, std::size_t size) {
    add(size);
}

void freed(const volatile void* place) {
    if (place) {
        subtract(__sanitizer_get_allocated_size(place));
    }
}

[[maybe_unused]] const int installed = __sanitizer_install_malloc_and_free_hooks(allocated, freed);

}  // namespace

#else

#include <malloc.h>

// In the place of the C library's, which do the work.
extern "C" {

void* __libc_malloc(std::size_t size);
void* __libc_calloc(std::size_t count, std::size_t size);
void* __libc_realloc(void* place, std::size_t size);
void* __libc_memalign(std::size_t alignment, std::size_t size);
void __libc_free(void* place);

static void* counted(void* place) {
    add(malloc_usable_size(place));
    return place;
}

void* malloc(std::size_t size) noexcept {
    return counted(__libc_malloc(size));
}

void* calloc(std::size_t count, std::size_t size) noexcept {
    return counted(__libc_calloc(count, size));
}

void* realloc(void* place, std::size_t size) noexcept {
    const std::size_t before = malloc_usable_size(place);
    void* const moved = __libc_realloc(place, size);
    if (moved || size == 0) {
        subtract(before);
    }
    return counted(moved);
}

void free(void* place) noexcept {
    subtract(malloc_usable_size(place));
    __libc_free(place);
}

void* memalign(std::size_t alignment, std::size_t size) noexcept {
    return counted(__libc_memalign(alignment, size));
}

void* aligned_alloc(std::size_t alignment, std::size_t size) noexcept {
    return counted(__libc_memalign(alignment, size));
}

int posix_memalign(void** place, std::size_t alignment, std::size_t size) noexcept {
    *place = counted(__libc_memalign(alignment, size));
    return *place ? 0 : ENOMEM;
}
}

#endif

namespace vybeg::fuzz {

void start_heap_peak() {
    at_start = held;
    most = at_start;
}

std::int64_t heap_peak() {
    return most - at_start;
}

}  // namespace vybeg::fuzz
