#pragma once

#include <cmath>
#include <cstdint>
#include <random>
#include <utility>

namespace vybeg {

// White Gaussian noise of unit variance, two independent numbers at a time, by Marsaglia's polar
// method. std::normal_distribution differs between standard libraries.
class GaussianNoise {
public:
    explicit GaussianNoise(std::uint64_t seed) : engine_(seed) {}

    std::pair<double, double> next() {
        double x = 0;
        double y = 0;
        double square = 0;
        do {
            x = uniform();
            y = uniform();
            square = x * x + y * y;
        } while (square >= 1 || square == 0);
        const double scale = std::sqrt(-2 * std::log(square) / square);
        return {x * scale, y * scale};
    }

private:
    // Uniform in [-1, 1), from the upper 53 bits.
    double uniform() { return static_cast<double>(engine_() >> 11) * 0x1p-52 - 1; }

    std::mt19937_64 engine_;
};

}  // namespace vybeg
