#include "core/estimators/wave/wave_formulas.h"

namespace vybeg {

WaveState to_wave_state(const Phasors& phasors) {
    return state_of(parts_of(phasors)).wave;
}

Phasors to_phasors(const WaveState& state) {
    const PhasorParts<double> z = phasors_of(turned(state));
    return {{z.c_re, z.c_im}, {z.d_re, z.d_im}};
}

double phase_difference(const Phasors& phasors) {
    return phase_difference_of(parts_of(phasors));
}

}  // namespace vybeg
