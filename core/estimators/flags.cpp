#include "core/estimators/flags.h"

#include <array>
#include <utility>

namespace vybeg {

std::string flags_text(Flags flags) {
    constexpr std::array<std::pair<Flag, const char*>, 5> names{
        {{Flag::no_quadrature, "no-quadrature"},
         {Flag::circular, "circular"},
         {Flag::gap, "gap"},
         {Flag::not_converged, "not-converged"},
         {Flag::at_bound, "at-bound"}}};
    std::string text;
    for (const auto& [flag, name] : names) {
        if (has(flags, flag)) {
            text += text.empty() ? "" : ";";
            text += name;
        }
    }
    return text;
}

}  // namespace vybeg
