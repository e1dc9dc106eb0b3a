#include "core/track/track.h"

#include "core/base/message_arg.h"
#include "core/numerics/phase.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace vybeg {
namespace {

template <class Value>
void append_all(std::vector<Value>& values, const std::vector<Value>& more) {
    values.insert(values.end(), more.begin(), more.end());
}

}  // namespace

const SlowVariableInfo& info(SlowVariable variable) {
    static constexpr std::array<SlowVariableInfo, slow_variable_count> table{{
        {"a_A", "a_A", "", VYBEG_MESSAGE("SlowVariable", "amplitude of the working wave"),
         Quantity::amplitude, true},
        {"a_B", "a_B", "", VYBEG_MESSAGE("SlowVariable", "amplitude of the quadrature wave"),
         Quantity::amplitude, true},
        {"two_theta_A_rad", "2θ_A", "rad",
         VYBEG_MESSAGE("SlowVariable", "angle of the standing wave"), Quantity::angle, true},
        {"f_Hz", "ω_cp", "Hz", VYBEG_MESSAGE("SlowVariable", "mean frequency"), Quantity::frequency,
         true},
        {"delta_phi_CD_rad", "Δφ_CD", "rad",
         VYBEG_MESSAGE("SlowVariable", "phase difference of the pick-off signals"), Quantity::angle,
         true},
        {"alpha_rad", "α", "rad", VYBEG_MESSAGE("SlowVariable", "phase of the standing waves"),
         Quantity::angle, true},
        {"noise", "σ", "",
         VYBEG_MESSAGE("SlowVariable", "noise per sample and channel, of the residual"),
         Quantity::amplitude, false},
        {"rms", "rms", "", VYBEG_MESSAGE("SlowVariable", "root of the error functional F"),
         Quantity::amplitude, false},
        {"orthogonality", "⟨S_A S_B⟩", "",
         VYBEG_MESSAGE("SlowVariable", "orthogonality of the standing waves, relative"),
         Quantity::ratio, false},
    }};
    return table[static_cast<std::size_t>(variable)];
}

Track::Track(std::size_t rows) : time_s_(rows), flags_(rows), leakage_f_hz_(rows) {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    for (const SlowVariable variable : all_slow_variables) {
        values_[index(variable)].assign(rows, nan);
        if (info(variable).has_sd) {
            sds_[index(variable)].assign(rows, nan);
        }
    }
}

void Track::put(std::size_t row, SlowVariable variable, double value, double sd) {
    values_[index(variable)][row] = value;
    if (info(variable).has_sd) {
        sds_[index(variable)][row] = sd;
    }
}

void Track::append(const Track& rows) {
    append_all(time_s_, rows.time_s_);
    append_all(flags_, rows.flags_);
    append_all(leakage_f_hz_, rows.leakage_f_hz_);
    for (std::size_t i = 0; i < slow_variable_count; ++i) {
        append_all(values_[i], rows.values_[i]);
        append_all(sds_[i], rows.sds_[i]);
    }
}

TrackSink appended_to(Track& track) {
    return [&track](const Track& rows) {
        track.append(rows);
        return Status{};
    };
}

void set_flags(std::span<Flags> part, std::size_t first, std::span<const FlaggedRows> flagged) {
    for (const FlaggedRows& rows : flagged) {
        const std::size_t end = std::min(rows.first + rows.count, first + part.size());
        for (std::size_t row = std::max(rows.first, first); row < end; ++row) {
            set(part[row - first], rows.flag);
        }
    }
}

void AngleUnwrapper::unwrap(Track& next_rows) {
    constexpr double pi = std::numbers::pi;
    const auto angle = next_rows.values(SlowVariable::two_theta_A);
    const auto alpha = next_rows.values(SlowVariable::alpha);
    for (std::size_t k = 0; k < next_rows.rows(); ++k) {
        if (std::isnan(angle[k])) {
            continue;
        }
        const double turned = angle[k] - two_theta_zero_;
        double branch = nearest_branch(turned, last_, pi);
        if (!any_ && branch <= -pi / 2) {
            branch += pi;
        }
        any_ = true;
        const auto half_turns = std::llround((branch - turned) / pi);
        if (half_turns % 2 != 0) {
            alpha[k] = wrap(alpha[k] + pi);
        }
        angle[k] = last_ = branch;
    }
}

}  // namespace vybeg
