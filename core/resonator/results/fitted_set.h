#pragma once

#include "core/resonator/fit/map_fit.h"
#include "core/resonator/fit/posterior.h"
#include "core/resonator/model/derived_quantities.h"
#include "core/resonator/results/resonator_result.h"

#include <Eigen/Core>

#include <span>
#include <vector>

namespace vybeg {

// The derived quantities at the maximum of the posterior with the three parts of each one's
// variance (posterior.h): from the data, from the known tolerances of the channels, and from priors
// without information, of parameters that the recordings do not determine.
struct ReportedVariances {
    Eigen::VectorXd value;
    Eigen::MatrixXd gradient;  // a row for each quantity, columns as posterior.active
    Eigen::VectorXd data;
    Eigen::VectorXd known;
    Eigen::VectorXd nothing;
    // Change of each quantity by an error of the size of each tolerance, told or assumed: root mean
    // square of both signs. Columns as channel_errors.
    Eigen::MatrixXd shares;
    Eigen::VectorXd spread;  // deviation of each quantity by the spread between the runs

    double sd(Eigen::Index quantity) const;     // of `data` and `nothing`
    double width(Eigen::Index quantity) const;  // of all three: deviation of the posterior
    double u(Eigen::Index quantity) const;      // of `sd`, `shares` and `spread`
    double total(Eigen::Index quantity) const {
        return data[quantity] + known[quantity] + nothing[quantity];
    }
};

// d(s^2)/d(active parameter), s of derived_quantities.h.
Eigen::VectorXcd square_gradient(const Posterior& posterior);

// By central differences. `beside`: parameters as likely as the maximum; `nothing` covers the
// values of the quantities at them. `moved`: changes of the active parameters by the tolerances
// (sensitivities.h); the quantities at both of their ends give the shares, because a size or an
// axis is not linear where an error is as large as the vector. `scattered`: changes of the active
// parameters by one deviation of each run from the set.
ReportedVariances reported_variances(const Posterior& posterior, const QuantityContext& context,
                                     const std::vector<ProfilePoint>& beside,
                                     const Eigen::MatrixXd& moved,
                                     const Eigen::MatrixXd& scattered);

// A set of runs with its most likely parameters.
struct SolvedSet {
    std::span<const PhasorRun> runs;  // as fitted
    std::span<const PhasorRun> fine;  // before their windows were merged
    const FitProblem* problem = nullptr;
    MapFit fit;
    ResonatorModel model{};
    double scale = 1;                // recording units of a scaled unit
    Estimate cubic_limit;            // b and its sd where it is held at zero; scaled units
    bool amplitude_or_time = false;  // settling frequencies explain the phasors as well as b
    RunDeviation spread;             // sd of the deviations of the runs from the set
    ChannelTolerance tolerance;      // told or assumed: the sizes of the errors in u
};

// A set with all that its numbers follow from. `tolerance`: of the free model that of the drifts
// alone.
struct FittedSet : SolvedSet {
    Posterior posterior{};
    QuantityContext context{};
    Eigen::MatrixXd moved{};      // by the tolerance (sensitivities.h)
    Eigen::MatrixXd scattered{};  // by one deviation of each run from the set
    ReportedVariances variances{};
    double split_needs = 3;  // least size of a given split or anisotropy, standard deviations
};

}  // namespace vybeg
