#pragma once

#include "core/base/job_control.h"
#include "core/base/result.h"
#include "core/numerics/lock_in.h"
#include "core/simulation/free_decay.h"
#include "core/track/track.h"

#include <array>
#include <complex>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

namespace vybeg {

// Receives frames of both signals in order; an error ends the simulation.
using DecaySink = std::function<Status(std::span<const double> c, std::span<const double> d)>;

struct SimulatedDecay {
    std::vector<double> c;
    std::vector<double> d;
    double full_scale = 0;  // of the quantiser, as used; 0: not quantised
};

// Full scale of the quantiser, as used; 0 without one. Unless it is given, the decay is simulated
// once to find its largest sample. Errors: simulation_impossible, interrupted.
Result<double> find_full_scale(const FreeDecay& decay, const JobControl& job);

// The two signals: slow motion by the exact matrix exponential, or, where frequency or damping
// depend on the amplitude, by Taylor steps good to rounding; friction and drive by Runge-Kutta
// steps; channels, noise, then the quantiser, which clips; `full_scale` is that of
// find_full_scale(); lost samples last. The sink receives some thousand frames at a time; memory
// does not grow with the length. The same seed gives the same samples on every machine, to the
// rounding of its sin, cos, exp and log. Errors: those of the sink, simulation_impossible,
// interrupted.
Status simulate(const FreeDecay& decay, double full_scale, const DecaySink& sink,
                const JobControl& job);

// The same in memory. Precondition: enough memory.
Result<SimulatedDecay> simulate(const FreeDecay& decay, const JobControl& job);

// Exact slow variables at the centres of consecutive windows of `window` samples, from the axes of
// the ellipse of (c, d): the wave itself, without errors of channels, noise about the carrier and
// lost samples. sd columns are zero, rms is the white noise's sqrt(2) sigma. f is f(t) plus the
// mean rate of phase of both signals, weighted with their power: Im(z^H dz/dt) / (2 pi |z|^2).
// Angles are NaN where the wave is circular within 1e-12 (flag circular), delta_phi_CD also where
// one of the signals vanishes. Errors: simulation_impossible.
Result<Track> true_track(const FreeDecay& decay, std::int64_t window);

// A lock-in of both channels of a simulated decay, in double precision: its stages filter
// 2 s(t) e^(-i w t) sample by sample.
class SoftwareLockIn {
public:
    // Rows of a log: every `samples_per_row` samples.
    SoftwareLockIn(const LockIn& filter, double f_ref_hz, double rate_hz,
                   std::int64_t samples_per_row);

    void take(std::span<const double> c, std::span<const double> d);

    // Rows t,Xc,Yc,Xd,Yd,F below a line of names, without those of the filter's settling; the times
    // are those at which the lock-in gave them.
    std::string table() const;

private:
    using Complex = std::complex<double>;

    LockIn filter_;
    double f_ref_hz_;
    double rate_hz_;
    std::int64_t samples_per_row_;
    double keep_;  // of a stage, from sample to sample
    std::int64_t frame_ = 0;
    std::array<std::vector<Complex>, 2> stages_;
    std::array<std::vector<Complex>, 2> rows_;
};

}  // namespace vybeg
