#include "core/output/stored_reason.h"

#include <algorithm>
#include <iterator>

namespace vybeg {
namespace {

// The code with this name, of those from `first` up to the first number without a name.
template <class Code>
std::optional<Code> code_named(const std::string& name, Code first, std::string (*name_of)(Code)) {
    for (int number = static_cast<int>(first);; ++number) {
        const auto code = static_cast<Code>(number);
        const std::string known = name_of(code);
        if (known.empty()) {
            return std::nullopt;
        }
        if (known == name) {
            return code;
        }
    }
}

std::vector<MessageArg> stored_args(const std::vector<std::string>& texts) {
    std::vector<MessageArg> args;
    std::ranges::transform(texts, std::back_inserter(args), stored_arg);
    return args;
}

}  // namespace

std::optional<Reason> stored_reason(const std::string& name, const std::vector<std::string>& args) {
    const auto code = code_named(name, static_cast<ReasonCode>(1), reason_name);
    return code ? std::optional(Reason{*code, stored_args(args)}) : std::nullopt;
}

std::optional<Diagnostic> stored_diagnostic(const std::string& name,
                                            const std::vector<std::string>& args) {
    const auto kind = code_named(name, DiagnosticKind{}, kind_name);
    return kind ? std::optional(Diagnostic{*kind, stored_args(args)}) : std::nullopt;
}

}  // namespace vybeg
