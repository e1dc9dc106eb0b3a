#pragma once

#include "core/estimators/wave/wave_state.h"
#include "core/resonator/model/phasor_run.h"
#include "core/resonator/model/reason.h"
#include "core/resonator/model/scaled_run.h"

#include <Eigen/Core>

#include <cstddef>
#include <span>

namespace vybeg {

// Decay time of a decay rate (1/s), given from five combined uncertainties on, because 1/x is
// biased below. Otherwise the reason: limits of two of them, or a growing motion. Precondition: it
// is given.
Estimate decay_time(const Estimate& rate);

// How the amplitude a = |z| of a recording falls: da/dt = -k a^p, by least squares of log a over
// the windows from the first to the last before a falls below ten deviations. p = 1 is the free
// decay of a resonator, p = 0 dry friction, p = 2 the friction of air (1/tau follows a). Where a
// free decay and one of these act together, |p - 1| is about the share of the other one.
struct DecayLaw {
    double power = 1;     // p
    double power_sd = 0;  // from the scatter, with its correlation; infinite: unknown
    double per_s = 0;     // decay rate at `amplitude`, and its deviation
    double per_s_sd = 0;
    double amplitude = 0;  // at the mean instant, recording units
    double largest = 0;    // by the law, first and last window
    double smallest = 0;
    double line_per_s = 0;  // decay rate of p = 1
    double chi2 = 0;        // of the law
    double line_chi2 = 0;   // of p = 1
    double still_chi2 = 0;  // of a constant amplitude
    std::size_t windows = 0;

    // Whether the law explains most of what a free decay leaves of the amplitude, and is no free
    // decay by five deviations.
    bool departs() const;
    // chi^2 in units of the scatter about the law: what a difference has to exceed.
    double scatter() const;
};

// Q over the amplitude: the amplitude at which the line's decay rate holds, and Q at both ends.
struct QBand {
    double amplitude = 0;
    double largest = 0;
    double q_at_largest = 0;
    double smallest = 0;
    double q_at_smallest = 0;
};

// `q`: of the line. Precondition: law.departs() and rates above 0; NaN otherwise.
QBand q_band(const DecayLaw& law, double q);

// chi^2 of the same windows' log a from that of an expected motion, one of each window.
double log_amplitude_chi2(const PhasorRun& run, std::span<const Phasors> expected);

// Precondition: the windows have finite values and deviations above 0. Fewer than eight windows
// above the noise: windows = 0.
DecayLaw decay_law(const PhasorRun& run);

// Decay of the power |z|^2 of a run, independent of phase and frequency: a weighted straight line
// through log |z|^2, down to a power of 100 noise variances.
struct EnvelopeDecay {
    double per_s = 0;  // 1/tau, half the slope
    // From the scatter about the line, at least that of the noise; infinite for fewer than three
    // usable windows.
    double sd = 0;
    double model_per_s = 0;  // the same line through the power of `expected`
};

// `expected`: the phasors of a fitted motion in the run's windows, scaled units.
EnvelopeDecay envelope_decay(const ScaledRun& run, std::span<const Eigen::Vector2cd> expected);

}  // namespace vybeg
