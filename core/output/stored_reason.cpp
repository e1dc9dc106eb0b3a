#include "core/output/stored_reason.h"

#include <algorithm>
#include <iterator>

namespace vybeg {

std::optional<Reason> stored_reason(const std::string& name, const std::vector<std::string>& args) {
    // Names of the codes, up to the first number without a name.
    for (int code = 1;; ++code) {
        const std::string known = reason_name(static_cast<ReasonCode>(code));
        if (known.empty()) {
            return std::nullopt;
        }
        if (known == name) {
            Reason reason{static_cast<ReasonCode>(code), {}};
            std::ranges::transform(args, std::back_inserter(reason.args), stored_arg);
            return reason;
        }
    }
}

}  // namespace vybeg
