#pragma once

#include "core/resonator/phasor_model.h"
#include "core/resonator/reason.h"

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace vybeg {

// Deviations of functions of the fitted parameters, from their covariance.
class DeltaMethod {
public:
    explicit DeltaMethod(Eigen::MatrixXd covariance) : covariance_(std::move(covariance)) {}

    // A gradient of zeros, in the coordinates shared, run 1, run 2, ...
    Eigen::VectorXd gradient() const { return Eigen::VectorXd::Zero(covariance_.rows()); }

    double sd(const Eigen::VectorXd& by) const {
        return std::sqrt(std::max(by.dot(covariance_ * by), 0.0));
    }

    Estimate estimate(double value, const Eigen::VectorXd& by) const { return {value, sd(by), {}}; }

    const Eigen::MatrixXd& covariance() const { return covariance_; }

    // Place of a run's own parameter.
    static Eigen::Index place(std::size_t run, int own) {
        return shared_count + own_count * static_cast<Eigen::Index>(run) + own;
    }

private:
    Eigen::MatrixXd covariance_;
};

}  // namespace vybeg
