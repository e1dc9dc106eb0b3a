#pragma once

#include "core/base/job_control.h"
#include "core/base/result.h"
#include "core/track/track.h"

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace vybeg {

// A simulated free decay (METHOD section 8): two degenerate modes of a resonator, let go at t = 0.
// Units in the names; angles in rad. The defaults are those of `simulate`; demo_decay() is the
// article's case, with a split, a decay and a noise under which a_B visibly swings and 2theta_A
// turns through an axis.
struct FreeDecay {
    double seconds = 28;
    double rate_hz = 33333;
    double f0_hz = 5300;
    double a_A = 1;
    double a_B = 0;
    double two_theta_A = 0.3;
    double alpha = 0.4;
    double split_hz = 0;                  // f_p - f_q >= 0
    double theta_w = 0;                   // axis of the faster mode
    double tau_s = 1e300;                 // amplitude decay time; the default is no decay
    double damping_anisotropy_per_s = 0;  // 1/tau_1 - 1/tau_2 >= 0
    double theta_tau = 0;                 // axis of larger damping
    double omega_rad_s = 0;               // rotation of the gyro
    double bryan = 0.277;                 // d theta_A/dt = -bryan * omega
    double noise = 0;                     // sd per sample and channel, recording units
    double kappa = 1;                     // S_D = D / kappa
    double offset_c = 0;
    double offset_d = 0;
    int bits = 0;           // 0: not quantised
    double full_scale = 0;  // of the quantiser; 0: 1.25 times the largest sample
    std::uint64_t seed = 1;

    friend bool operator==(const FreeDecay&, const FreeDecay&) = default;
};

// Takes frames of both signals in their order; an error ends the simulation.
using DecaySink = std::function<Status(std::span<const double> c, std::span<const double> d)>;

struct SimulatedDecay {
    std::vector<double> c;
    std::vector<double> d;
    double full_scale = 0;  // of the quantiser, as used; 0: not quantised
};

FreeDecay demo_decay();

// Whether the decay can be simulated at all: simulation_impossible with the reason.
Status check(const FreeDecay& decay);

// Frames of the record: floor(seconds * rate), a product within 1e-6 below a whole number counting
// as whole. Precondition: check() passes.
std::int64_t frame_count(const FreeDecay& decay);

// Full scale of the quantiser, as used; 0 without one. Where it is not given the decay is simulated
// once to find its largest sample. Errors: simulation_impossible, interrupted.
Result<double> find_full_scale(const FreeDecay& decay, const JobControl& job);

// The two signals by the exact matrix exponential of the slow dynamics: signal, D divided by
// kappa, plus offset, plus noise, then the quantiser, which clips; `full_scale` is that of
// find_full_scale(). The sink gets some thousand frames at a time: memory does not grow with the
// length. The same seed gives the same samples on every machine, to the rounding of its sin, cos,
// exp and log. Errors: those of the sink, simulation_impossible, interrupted.
Status simulate(const FreeDecay& decay, double full_scale, const DecaySink& sink,
                const JobControl& job);

// The same in memory, which must have room for it.
Result<SimulatedDecay> simulate(const FreeDecay& decay, const JobControl& job);

// The exact slow variables at the centres of windows of `window` samples, one after the other, from
// the axes of the ellipse that (C, D) runs through; sd columns are zero, rms is the noise's sqrt(2)
// sigma. f is f0 plus the mean rate of phase of both signals, weighted with their power:
// Im(z^H dz/dt) / (2 pi |z|^2). Angles are NaN where the wave is circular within 1e-12 (flag
// circular), delta_phi_CD also where one of the signals vanishes. Errors: simulation_impossible.
Result<Track> true_track(const FreeDecay& decay, std::int64_t window);

}  // namespace vybeg
