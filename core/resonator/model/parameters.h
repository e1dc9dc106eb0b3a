#pragma once

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace vybeg {

// Parameters of a set of runs in one vector (FIT section 1): those of the resonator and of the
// channels, common to all runs, then each run's own. The vector always has all parameters; a held
// one has a prior of width zero.

// Shared parameters. The first rate_count are the rates in M (slow_dynamics.h).
enum SharedParameter : int {
    split_cos_at,      // split cos 4theta_w, Hz
    split_sin_at,      // split sin 4theta_w, Hz
    damping_cos_at,    // g cos 4theta_tau, g = 1/tau_1 - 1/tau_2, 1/s
    damping_sin_at,    // g sin 4theta_tau, 1/s
    rotation_at,       // r = 2 k Omega, 1/s; d theta_A/dt = -r/2
    free_rotation_at,  // imaginary part of r: zero except in the free model
    decay_at,          // 1/tau, 1/s
    kappa_at,          // gain ratio, D = kappa S_D
    skew_at,           // non-orthogonality, rad: the pick-off of D records sin(skew) C in addition
    phase_at,          // of D against C, rad; a delay of D is -2 pi f delay
    crosstalk_at,      // of C into D in quadrature
    phase_drift_at,    // of D over the run, rad
    gain_drift_at,     // of D over the run
    cubic_at,          // b, Hz per scaled unit^2: isotropic cubic spring
    shared_count
};
inline constexpr int rate_count = decay_at + 1;

// Their names in results.
inline constexpr auto shared_names = std::to_array<const char*>(
    {"split_cos4_hz", "split_sin4_hz", "damping_cos4_per_s", "damping_sin4_per_s", "rotation_per_s",
     "skew_per_s", "decay_per_s", "kappa", "non_orthogonality_rad", "phase_rad", "crosstalk",
     "phase_drift_rad", "gain_drift", "frequency_per_power"});
static_assert(shared_names.size() == shared_count);

// A run's own parameters; after them those of each break of the run (phasor_model.h).
enum OwnParameter : int {
    start_at,          // Re c, Im c, Re d, Im d at t = 0, scaled units
    frequency_at = 4,  // Hz from f_ref, at the run's reference instant and power
    drift_at,          // Hz/s
    own_count
};

// Start of each run's own parameters, and total number.
class ParameterLayout {
public:
    // `breaks[k]` parameters of breaks in run k.
    explicit ParameterLayout(std::span<const std::size_t> breaks) {
        Eigen::Index next = shared_count;
        for (const std::size_t count : breaks) {
            first_.push_back(next);
            next += own_count + static_cast<Eigen::Index>(count);
        }
        first_.push_back(next);
    }

    std::size_t runs() const { return first_.size() - 1; }
    Eigen::Index size() const { return first_.back(); }
    Eigen::Index at(std::size_t run, int own) const { return first_[run] + own; }
    Eigen::Index own_size(std::size_t run) const { return first_[run + 1] - first_[run]; }

private:
    std::vector<Eigen::Index> first_;
};

}  // namespace vybeg
