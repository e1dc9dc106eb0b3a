#include "core/numerics/fft.h"

#include <fftw3.h>

#include <memory>
#include <mutex>

namespace vybeg {
namespace {

// FFTW chooses its SIMD code by the alignment of the array it plans with; all arrays from new must
// therefore share it.
static_assert(__STDCPP_DEFAULT_NEW_ALIGNMENT__ >= 16);

std::mutex& planner_mutex() {
    static std::mutex mutex;
    return mutex;
}

// FFTW terminates the program if an allocation fails. This allocates the upper limit of its need,
// with a margin for small blocks, beforehand, which throws std::bad_alloc. The memory is never
// touched.
void ask_for_memory(std::size_t elements) {
    std::allocator<std::complex<double>> memory;
    const std::size_t count = elements + (std::size_t{1} << 16);
    memory.deallocate(memory.allocate(count), count);
}

void execute(const fftw_plan plan, std::span<std::complex<double>> data) {
    // The buffers of shorter transforms are negligible.
    if (data.size() >= std::size_t{1} << 16) {
        ask_for_memory(data.size());
    }
    auto* const array =
        reinterpret_cast<fftw_complex*>(data.data());  // one layout, by both standards
    fftw_execute_dft(plan, array, array);
}

}  // namespace

Fft::Fft(std::size_t size) : size_(size) {
    ask_for_memory(4 * size);
    // An estimated plan reads only the address of the array; its memory is never touched.
    const std::unique_ptr<double[]> scratch(new double[2 * size]);
    auto* const array = reinterpret_cast<fftw_complex*>(scratch.get());
    const auto plan = [&](int sign) {
        // Measured plans differ between executions, and with them the last bits.
        return fftw_plan_dft_1d(static_cast<int>(size), array, array, sign, FFTW_ESTIMATE);
    };
    const std::lock_guard lock(planner_mutex());
    forward_ = plan(FFTW_FORWARD);
    inverse_ = plan(FFTW_BACKWARD);
}

Fft::~Fft() {
    const std::lock_guard lock(planner_mutex());
    fftw_destroy_plan(forward_);
    fftw_destroy_plan(inverse_);
}

void Fft::forward(std::span<std::complex<double>> data) const {
    execute(forward_, data);
}

void Fft::inverse(std::span<std::complex<double>> data) const {
    execute(inverse_, data);
}

}  // namespace vybeg
