#include "core/resonator/passport.h"

#include "core/resonator/resonator_parameters.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace vybeg {
namespace {

constexpr double changed_from_deviations = 3;

void add(std::string name, const char* unit, const Estimate& then, const Estimate& now,
         double period, std::vector<Difference>& differences) {
    if (!then.given() && !now.given()) {
        return;
    }
    Difference difference{std::move(name), unit, then, now};
    if (!then.given() || !now.given()) {
        difference.change = std::numeric_limits<double>::quiet_NaN();
        difference.sd = difference.change;
        difference.verdict = Verdict::not_comparable;
    } else {
        const double change = now.value - then.value;
        difference.change = period > 0 ? std::remainder(change, period) : change;
        difference.sd = std::hypot(then.sd, now.sd);
        difference.verdict = difference.deviations() < changed_from_deviations ? Verdict::unchanged
                                                                               : Verdict::changed;
    }
    differences.push_back(std::move(difference));
}

ModeEstimate no_mode(const Reason& reason) {
    ModeEstimate mode;
    for (const ModeParameter& parameter : mode_parameters) {
        (mode.*parameter.member).reason = reason;
    }
    return mode;
}

}  // namespace

const char* verdict_name(Verdict verdict) {
    switch (verdict) {
        case Verdict::unchanged: return "unchanged";
        case Verdict::changed: return "changed";
        case Verdict::not_comparable: return "not comparable";
    }
    return "";
}

double Difference::deviations() const {
    // Two values without any deviation, such as those given by hand, differ or do not.
    return change == 0 ? 0 : std::abs(change) / sd;
}

std::vector<Difference> compare(const Passport& passport, const ResonatorFit& now) {
    std::vector<Difference> differences;
    for (const ResonatorParameter& parameter : resonator_parameters) {
        add(parameter.name, parameter.unit, passport.resonator.*parameter.member,
            now.resonator.*parameter.member, parameter.period, differences);
    }
    const std::size_t modes = std::max(passport.modes.size(), now.modes.size());
    for (std::size_t k = 0; k < modes; ++k) {
        const ModeEstimate none = no_mode({ReasonCode::modes_not_apart, {}});
        const ModeEstimate& then_mode = k < passport.modes.size() ? passport.modes[k] : none;
        const ModeEstimate& now_mode = k < now.modes.size() ? now.modes[k] : none;
        for (const ModeParameter& parameter : mode_parameters) {
            add("modes[" + std::to_string(k) + "]." + parameter.name, parameter.unit,
                then_mode.*parameter.member, now_mode.*parameter.member, 0, differences);
        }
    }
    return differences;
}

}  // namespace vybeg
