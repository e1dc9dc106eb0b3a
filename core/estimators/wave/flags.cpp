#include "core/estimators/wave/flags.h"

#include <array>
#include <string_view>
#include <utility>

namespace vybeg {
namespace {

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
