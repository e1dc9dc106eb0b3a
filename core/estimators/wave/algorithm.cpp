#include "core/estimators/wave/estimator.h"

#include <array>
#include <utility>

namespace vybeg {
namespace {

constexpr std::array<std::pair<Algorithm, std::string_view>, 6> names{{
    {Algorithm::in_phase, "in-phase"},
    {Algorithm::phase_shift, "phase-shift"},
    {Algorithm::moving_axes, "moving-axes"},
    {Algorithm::demodulation, "demodulation"},
    {Algorithm::conjugate_gradient, "conjugate-gradient"},
    {Algorithm::maximum_likelihood, "maximum-likelihood"},
}};

}  // namespace

std::string_view algorithm_name(Algorithm algorithm) {
    return names[static_cast<std::size_t>(algorithm)].second;
}

std::optional<Algorithm> algorithm_from_name(std::string_view name) {
    for (const auto& [algorithm, known] : names) {
        if (known == name) {
            return algorithm;
        }
    }
    return std::nullopt;
}

}  // namespace vybeg
