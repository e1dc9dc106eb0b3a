#pragma once

#include "core/resonator/fit/posterior.h"
#include "core/resonator/fit/unseen_directions.h"
#include "core/resonator/model/derived_quantities.h"

#include <Eigen/Core>

#include <vector>

namespace vybeg {

// The derived quantities at the maximum of the posterior with the three parts of each one's
// variance.
struct ReportedVariances {
    Eigen::VectorXd value;
    Eigen::MatrixXd gradient;  // a row for each quantity, columns as posterior.active
    Eigen::VectorXd data;
    Eigen::VectorXd known;
    Eigen::VectorXd nothing;

    double sd(Eigen::Index quantity) const;  // of data and undetermined parameters
    double u(Eigen::Index quantity) const;   // with the channels
    double total(Eigen::Index quantity) const {
        return data[quantity] + known[quantity] + nothing[quantity];
    }
};

// d(s^2)/d(active parameter), s of derived_quantities.h.
Eigen::VectorXcd square_gradient(const Posterior& posterior);

// By central differences; `beside` widens `nothing` to the values of equally likely parameters.
ReportedVariances reported_variances(const Posterior& posterior, const QuantityContext& context,
                                     const std::vector<ProfilePoint>& beside);

}  // namespace vybeg
