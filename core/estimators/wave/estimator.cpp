#include "core/estimators/wave/estimator.h"

#include <algorithm>
#include <array>
#include <span>
#include <string_view>
#include <utility>

namespace vybeg {
namespace {

// As Algorithm.
constexpr std::array<std::string_view, all_algorithms.size()> names{
    "in-phase",     "phase-shift",        "moving-axes",
    "demodulation", "conjugate-gradient", "maximum-likelihood"};

constexpr std::array<std::pair<Flag, const char*>, 10> flag_names{{
    {Flag::no_quadrature, "no-quadrature"},
    {Flag::circular, "circular"},
    {Flag::gap, "gap"},
    {Flag::clipped, "clipped"},
    {Flag::not_converged, "not-converged"},
    {Flag::at_bound, "at-bound"},
    {Flag::filter_transient, "filter-transient"},
    {Flag::delay_reach, "delay-reach"},
    {Flag::leakage, "leakage"},
    {Flag::moving, "moving"},
}};

constexpr std::size_t length_of_all() {
    std::size_t length = 0;
    for (const auto& [flag, name] : flag_names) {
        length += std::string_view(name).size() + 1;
    }
    return length;
}
static_assert(length_of_all() <= longest_flags_text);

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

std::string flags_text(Flags flags) {
    std::string text;
    for (const auto& [flag, name] : flag_names) {
        if (has(flags, flag)) {
            text += text.empty() ? "" : ";";
            text += name;
        }
    }
    return text;
}

}  // namespace vybeg
