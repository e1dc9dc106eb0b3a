#pragma once

#include "core/base/message_arg.h"

#include <limits>
#include <string>
#include <vector>

namespace vybeg {

struct ReasonSentence {
    VYBEG_CONTEXT(Reason)
    static constexpr const char* tr(const char* text) { return text; }
};

// Reasons for which a number of the resonator is not given, by the rows of reason_rows.h.
enum class ReasonCode {
#define ROW(code, sentence) code,
#include "core/resonator/model/reason_rows.h"
#undef ROW
};

struct Reason {
    ReasonCode code = ReasonCode::none;
    std::vector<MessageArg> args;

    friend bool operator==(const Reason&, const Reason&) = default;
};

// A number with its standard deviation, or the reason for its absence with NaN for both.
struct Estimate {
    double value = std::numeric_limits<double>::quiet_NaN();
    double sd = std::numeric_limits<double>::quiet_NaN();  // statistical
    Reason reason;
    // Combined standard uncertainty: sd and the contribution of the tolerances, stated or assumed.
    // NaN without tolerances.
    double u = std::numeric_limits<double>::quiet_NaN();

    bool given() const { return reason.code == ReasonCode::none; }
    double uncertainty() const { return u >= sd ? u : sd; }

    friend Estimate operator*(double factor, Estimate estimate) {
        for (double* const each : {&estimate.value, &estimate.sd, &estimate.u}) {
            *each *= factor;
        }
        return estimate;
    }
};

// Name of a reason in JSON, e.g. "one-direction".
std::string reason_name(ReasonCode code);

// With its English sentence, %1, %2, ... are the arguments (context "Reason"), and no grade.
MessageRow message_row(ReasonCode code);

// The whole English sentence.
std::string english(const Reason& reason);

}  // namespace vybeg
