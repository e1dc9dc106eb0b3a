#pragma once

#include <complex>
#include <cstddef>
#include <span>

struct fftw_plan_s;

namespace vybeg {

// Complex FFT of one fixed length, in place, unnormalised: forward() then inverse() multiplies by
// size(). Construction and destruction are guarded, because FFTW's planner is global. forward() and
// inverse() may be called from several threads at once and return the same bits for the same input.
class Fft {
public:
    // Precondition: 1 <= size <= the largest int.
    explicit Fft(std::size_t size);
    ~Fft();
    Fft(const Fft&) = delete;
    Fft& operator=(const Fft&) = delete;

    std::size_t size() const { return size_; }

    // X[k] = sum over j of x[j] exp(-2 pi i j k / size). Precondition of both: data.size() ==
    // size(), allocated by new (as in a std::vector) and not offset by less than a whole element.
    void forward(std::span<std::complex<double>> data) const;
    // x[j] = sum over k of X[k] exp(+2 pi i j k / size).
    void inverse(std::span<std::complex<double>> data) const;

private:
    std::size_t size_;
    fftw_plan_s* forward_;
    fftw_plan_s* inverse_;
};

}  // namespace vybeg
