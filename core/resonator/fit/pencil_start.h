#pragma once

#include "core/resonator/fit/map_fit.h"

#include <Eigen/Core>

#include <optional>

namespace vybeg {

// two_channels: z(t + lag) = E z(t) in least squares over one run or over all, M = log(E)/lag;
// delayed: delayed_pencil.h, for channels with nearly the same mixture, at ten times the cost.
enum class Pencil { two_channels, delayed };

// Start values from the best matrix pencil of a kind, for lags from one window to a third of the
// run. They find resolved pairs; for a nearly still wave they are missing or useless. Held
// parameters are at their means.
std::optional<Eigen::VectorXd> pencil_start(const FitProblem& problem, Pencil kind,
                                            const JobControl& job);

// chi^2 of all runs, as measured, at p.
double chi_square_at(const FitProblem& problem, const Eigen::VectorXd& p);

}  // namespace vybeg
