#pragma once

#include "core/resonator/fit/posterior.h"
#include "core/resonator/fit/unseen_directions.h"
#include "core/resonator/model/derived_quantities.h"

#include <Eigen/Core>

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

}  // namespace vybeg
