#pragma once

#include "core/resonator/fit/map_fit.h"
#include "core/resonator/fit/posterior.h"
#include "core/resonator/results/resonator_result.h"

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

inline Eigen::Index quantity_of_run(std::size_t run, int quantity) {
    return shared_quantities + run_quantities * static_cast<Eigen::Index>(run) + quantity;
}

// The derived quantities at the maximum of the posterior with the three parts of each one's
// variance (posterior.h): from the data, from the known tolerances of the channels, and from priors
// without information, of parameters that the recordings do not determine.
struct ReportedVariances {
    Eigen::VectorXd value;
    Eigen::MatrixXd gradient;  // a row for each quantity, columns as posterior.active
    Eigen::VectorXd data;
    Eigen::VectorXd known;
    Eigen::VectorXd nothing;
    // Change of each quantity by an error of the size of each tolerance, stated or assumed: root
    // mean square of both signs. Columns as moved_by().
    Eigen::MatrixXd shares;
    Eigen::VectorXd spread;  // deviation of each quantity by the spread between the runs

    double sd(Eigen::Index quantity) const;     // of `data` and `nothing`
    double width(Eigen::Index quantity) const;  // of all three: deviation of the posterior
    double u(Eigen::Index quantity) const;      // of `sd`, `shares` and `spread`
    double total(Eigen::Index quantity) const {
        return data[quantity] + known[quantity] + nothing[quantity];
    }
};

// s of the eigenvalues -1/tau +- s of M, squared, and d(s^2)/d(active parameter).
std::complex<double> square_half_difference(const Eigen::VectorXd& p);
Eigen::VectorXcd square_gradient(const Posterior& posterior);

// A set of runs with its most likely parameters and, once describe() has them, all that its numbers
// follow from.
struct FittedSet {
    std::span<const PhasorRun> runs;  // as fitted
    std::span<const PhasorRun> fine;  // before their windows were merged
    const FitProblem* problem = nullptr;
    MapFit fit{};
    ResonatorModel model{};
    double scale = 1;                // recording units of a scaled unit
    Estimate cubic_limit{};          // b and its sd where it is held at zero; scaled units
    bool amplitude_or_time = false;  // settling frequencies explain the phasors as well as b
    RunDeviation spread = RunDeviation::Zero();  // sd of the deviations of the runs from the set
    // Stated or assumed: the sizes of the errors in u; of the free model the drifts alone.
    ChannelTolerance tolerance = untold_channels;
    // By describe().
    Posterior posterior{};
    ModeOrder order{};
    Eigen::MatrixXd moved{};      // moved_by() the tolerance
    Eigen::MatrixXd scattered{};  // active parameters by one deviation of each run from the set
    ReportedVariances variances{};
    double split_needs = 3;  // least size of a given split or anisotropy, standard deviations

    double mean_f_ref_hz() const;
};

// The variances of a set with all the rest, by central differences. `beside`: parameters as likely
// as the maximum; `nothing` covers the values of the quantities at them. The quantities at both
// ends of what a tolerance moves give the shares, because a size or an axis is not linear where an
// error is as large as the vector.
ReportedVariances reported_variances(const FittedSet& set, const std::vector<ProfilePoint>& beside);

// Errors of the active parameters by channel errors of the size of their tolerances, of which the
// fit knows no more than its priors: columns as channel_errors, then drifts of C, phase
// and gain, as large as those of D. With J e the error in the phasors,
// S the covariance and F the information, S F_e e where the fit holds the error at zero, and
// -S_e e/s^2 where it has the prior s.
Eigen::MatrixXd moved_by(const FittedSet& set);

// Adds by how much the resonator's parameters and the numbers of each mode are wrong per unit of
// each error, in the order of resonator_parameters and of ModeEstimate; NaN if a parameter is not
// given. Of the structured model.
void add_sensitivities(const FittedSet& set, ResonatorFit& fit);

// Contributions of the channels' tolerances to the parameters' combined uncertainties, in the
// order of resonator_parameters. Zeros if a parameter is not given.
std::vector<BySource> tolerance_shares(const FittedSet& set, const ResonatorEstimate& resonator);

}  // namespace vybeg
