#pragma once

#include "core/resonator/fit/map_fit.h"
#include "core/resonator/model/phasor_model.h"

#include <Eigen/Core>

#include <cstddef>
#include <optional>
#include <vector>

namespace vybeg {

// Rates of a resolved pair from one run whose channels may contain nearly the same mixture of its
// modes, such as two microphones (ESPRIT, Roy and Kailath). The stacked vectors z(t), z(t + delay),
// z(t + 2 delay), ... lie in the plane of two modes, the two largest principal directions. There
// the step by one window is a 2x2 matrix with the eigenvalues of the modes; their shapes follow by
// least squares. `z`: the run's phasors without the mean rotation; `delay` in windows. Empty for
// too few windows or two modes of one shape.
std::optional<SlowRates> delayed_pencil(const ScaledRun& run,
                                        const std::vector<Eigen::Vector2cd>& z, std::size_t delay);

// two_channels: z(t + lag) = E z(t) in least squares over one run or over all, M = log(E)/lag;
// delayed: delayed_pencil(), for channels with nearly the same mixture, at ten times the cost.
enum class Pencil { two_channels, delayed };

// Start values from the best matrix pencil of a kind, for lags from one window to a third of the
// run. They find resolved pairs; for a nearly still wave they are missing or useless. Held
// parameters are at their means.
std::optional<Eigen::VectorXd> pencil_start(const FitProblem& problem, Pencil kind,
                                            const JobControl& job);

// Frequency and start of every run under given rates: the phasors are propagated back by exp(-N t);
// the frequency is their mean rotation over increasing lags; the start is linear.
Eigen::VectorXd parameters_under(const FitProblem& problem, const SlowRates& rates);

}  // namespace vybeg
