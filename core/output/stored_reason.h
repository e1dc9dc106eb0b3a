#pragma once

#include "core/base/diagnostic.h"
#include "core/resonator/model/reason.h"

#include <optional>
#include <string>
#include <vector>

namespace vybeg {

// The reason with this name in JSON (reason_name()) and these arguments, as they read in English;
// nothing: this version knows no such reason.
std::optional<Reason> stored_reason(const std::string& name, const std::vector<std::string>& args);

// The same for a diagnostic and kind_name().
std::optional<Diagnostic> stored_diagnostic(const std::string& name,
                                            const std::vector<std::string>& args);

}  // namespace vybeg
