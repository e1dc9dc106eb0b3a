#include "core/estimators/batch/wave_functional.h"

namespace vybeg {

WaveFunctional<double> evaluate_functional(const WaveParameters& parameters, const Moments& moments,
                                           const WindowKernel& kernel) {
    return wave_functional(turned(parameters.state), jets_of(moments, kernel),
                           kernel.gram_cos + kernel.gram_sin);
}

}  // namespace vybeg
