#include "core/resonator/results/raw_parameters.h"

#include <array>
#include <string>

namespace vybeg {
namespace {

constexpr std::array<const char*, shared_count> shared_names{"split_cos4_hz",
                                                             "split_sin4_hz",
                                                             "damping_cos4_per_s",
                                                             "damping_sin4_per_s",
                                                             "rotation_per_s",
                                                             "skew_per_s",
                                                             "decay_per_s",
                                                             "kappa",
                                                             "non_orthogonality_rad",
                                                             "phase_rad",
                                                             "crosstalk",
                                                             "phase_drift_rad",
                                                             "gain_drift",
                                                             "frequency_per_power"};
constexpr std::array<const char*, own_count> own_names{"c_re", "c_im", "d_re",
                                                       "d_im", "f_hz", "drift_hz_per_s"};

}  // namespace

RawParameters raw_parameters(const FittedSet& set, std::span<const PhasorRun> runs) {
    const ParameterLayout& layout = set.problem->layout;
    const Posterior& at = set.posterior;
    // Name, unit in recording units, origin of each parameter.
    const auto count = static_cast<std::size_t>(layout.size());
    std::vector<std::string> names(count);
    Eigen::VectorXd unit = Eigen::VectorXd::Ones(layout.size());
    Eigen::VectorXd origin = Eigen::VectorXd::Zero(layout.size());
    for (std::size_t k = 0; k < shared_names.size(); ++k) {
        names[k] = shared_names[k];
    }
    unit[cubic_at] = 1 / (set.scale * set.scale);
    for (std::size_t run = 0; run < runs.size(); ++run) {
        for (Eigen::Index k = 0; k < layout.own_size(run); ++k) {
            const Eigen::Index place = layout.at(run, 0) + k;
            names[static_cast<std::size_t>(place)] =
                "run" + std::to_string(run + 1) + "." +
                (k < own_count ? own_names[static_cast<std::size_t>(k)]
                               : "break" + std::to_string(k - own_count + 1) + "_rad");
            if (k < frequency_at) {
                unit[place] = set.scale;
            }
        }
        origin[layout.at(run, frequency_at)] = runs[run].f_ref_hz;
    }
    const Eigen::MatrixXd covariance = at.covariance_of(0, at.root.rows());
    RawParameters raw;
    for (std::size_t row = 0; row < at.active.size(); ++row) {
        const Eigen::Index parameter = at.active[row];
        raw.names.push_back(names[static_cast<std::size_t>(parameter)]);
        raw.values.push_back(origin[parameter] + unit[parameter] * at.p[parameter]);
        for (std::size_t column = 0; column < at.active.size(); ++column) {
            raw.covariance.push_back(
                unit[parameter] * unit[at.active[column]] *
                covariance(static_cast<Eigen::Index>(row), static_cast<Eigen::Index>(column)));
        }
    }
    return raw;
}

}  // namespace vybeg
