#pragma once

#include "core/resonator/model/phasor_run.h"

#include <vector>

namespace vybeg {

// What a controller writes down of one free decay when it keeps no phase:
// with c and d the phasors of both channels,
//     E = |c|^2 + |d|^2    R = |c|^2 - |d|^2    S = 2 Re(c conj d)    Q = 2 Im(c conj d) = 2 a_A
//     a_B
// E^2 = R^2 + S^2 + Q^2 but for the noise. Of channels x = Cx cos wt + Sx sin wt, c = Cx - i Sx, it
// is Q = 2 (Cx Sy - Cy Sx).
struct PowerRun {
    std::vector<double> time_s;  // rising
    std::vector<double> e;       // squared recording units; NaN: missing
    std::vector<double> r;
    std::vector<double> s;
    std::vector<double> q;
    double two_theta_zero = 0;  // as PhasorRun
};

// Powers of the waves a_A, a_B at theta_A (METHOD section 1), whose phase is not needed.
// Precondition: equal lengths.
PowerRun powers_of_waves(std::vector<double> time_s, const std::vector<double>& a_A,
                         const std::vector<double>& a_B, const std::vector<double>& theta_A);

// By how much R^2 + S^2 + Q^2 differs from E^2, as a share of it, beyond noise: a column has
// another unit, gain or offset, which no residual need show.
struct PowerMismatch {
    double of_all = 0;  // of the whole run, by its power
    double worst = 0;   // of its parts: an offset shows where the wave is small
    double at_s = 0;    // the middle of that part
};
PowerMismatch power_mismatch(const PowerRun& run);

// The phasors of a run up to their phase, `phase_lost`: |z|^2 is E, the rest is the direction of
// (R, S, Q). Rows without a number or without power are left out; more than `most` rows are merged.
// sd is that of equal noise of E, R, S and Q by their third differences.
PhasorRun phasors_without_phase(const PowerRun& run, std::size_t most);

}  // namespace vybeg
