#include "core/estimators/wave/estimator.h"

#include <algorithm>
#include <array>
#include <span>

namespace vybeg {
namespace {

// As Algorithm.
constexpr std::array<std::string_view, all_algorithms.size()> names{
    "in-phase",     "phase-shift",        "moving-axes",
    "demodulation", "conjugate-gradient", "maximum-likelihood"};

}  // namespace

std::string_view algorithm_name(Algorithm algorithm) {
    return names[static_cast<std::size_t>(algorithm)];
}

std::string algorithm_names() {
    std::string list(names.front());
    for (const std::string_view name : std::span(names).subspan(1)) {
        list.append(name == names.back() ? " or " : ", ").append(name);
    }
    return list;
}

std::optional<Algorithm> algorithm_from_name(std::string_view name) {
    const auto found = std::ranges::find(names, name);
    return found == names.end() ? std::nullopt
                                : std::optional(static_cast<Algorithm>(found - names.begin()));
}

}  // namespace vybeg
