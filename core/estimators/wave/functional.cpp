#include "core/estimators/wave/functional.h"

#include "core/estimators/wave/wave_functional.h"

#include <cmath>

namespace vybeg {

Functional evaluate_functional(const WaveParameters& parameters, const Moments& moments,
                               const WindowKernel& kernel) {
    const WaveState& state = parameters.state;
    const TurnedWave<double> wave{state.a_A,
                                  state.a_B,
                                  std::cos(state.two_theta_A),
                                  std::sin(state.two_theta_A),
                                  std::cos(state.alpha),
                                  std::sin(state.alpha)};
    // d/dw multiplies by -iu.
    const auto jet = [](const ChannelMoments& z) {
        return ComplexJet<double>{{z[0].real(), z[1].imag(), -z[2].real()},
                                  {z[0].imag(), -z[1].real(), -z[2].imag()}};
    };
    const double n = kernel.gram_cos + kernel.gram_sin;
    const WaveFunctional<double> f =
        wave_functional(wave, jet(moments.c), jet(moments.d),
                        {kernel.gram_cos - kernel.gram_sin, 2 * kernel.slope, 2 * kernel.bend}, n);
    Functional functional;
    functional.value = f.value;
    for (int row = 0; row < 5; ++row) {
        const auto r = static_cast<std::size_t>(row);
        functional.gradient[row] = f.gradient[r];
        for (int column = 0; column < 5; ++column) {
            functional.hessian(row, column) = f.hessian[r][static_cast<std::size_t>(column)];
        }
    }
    return functional;
}

}  // namespace vybeg
