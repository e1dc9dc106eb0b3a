#pragma once

#include "core/resonator/model/parameters.h"
#include "core/resonator/model/scaled_run.h"

#include <Eigen/Core>

#include <complex>
#include <span>
#include <vector>

namespace vybeg {

// Reported quantities, functions of the fitted parameters, in one vector: those of the resonator,
// then those of each run. Amplitudes in scaled units, frequencies in Hz without the reference.
enum SharedQuantity : int {
    f_mean_of,  // mean of the runs' frequencies, from the mean of their references
    decay_of,   // 1/tau, 1/s
    split_of,
    theta_w_of,
    damping_of,
    theta_tau_of,
    angle_rate_of,
    kappa_of,
    skew_of,
    phase_of,
    cubic_of,
    mode_f_of,                      // of the first mode; the second follows
    mode_decay_of = mode_f_of + 2,  // likewise
    shared_quantities = mode_decay_of + 2
};
enum RunQuantity : int {
    a_A_of,
    a_B_of,
    two_theta_of,
    f_of,         // from the run's reference
    f_offset_of,  // from f_mean_of, references included
    run_drift_of,
    split_sin_of,        // split sin 4(theta_A - theta_w)
    direction_f_of,      // frequency and decay rate of the run's own direction at its start
    direction_decay_of,  // 1/s
    run_quantities
};

// Modes by falling frequency, or by falling decay rate where the frequencies do not differ.
enum class ModeOrder { frequency, decay };

// Input of the quantities besides the parameters.
struct QuantityContext {
    const ParameterLayout* layout = nullptr;
    std::span<const ScaledRun> runs;
    std::vector<double> f_ref_hz;  // of each run
    ModeOrder order = ModeOrder::frequency;

    double mean_f_ref_hz() const;
};

inline Eigen::Index quantity_of_run(std::size_t run, int quantity) {
    return shared_quantities + run_quantities * static_cast<Eigen::Index>(run) + quantity;
}

// Values at p. Amplitudes and angle of a wave are those at t = 0, corrected for the mean over a
// window.
Eigen::VectorXd quantities(const Eigen::VectorXd& p, const QuantityContext& context);

// The period of each quantity that is an angle, rad; 0 for the others.
Eigen::VectorXd quantity_periods(std::size_t runs);

// s of the eigenvalues -1/tau +- s of M, squared.
std::complex<double> square_half_difference(const Eigen::VectorXd& p);

}  // namespace vybeg
