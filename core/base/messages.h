#pragma once

#include "core/base/diagnostic.h"
#include "core/base/error.h"

#include <string>

namespace vybeg {

// English sentence template of a code, with %1 for `where` (errors) and %2, %3, ... for the
// arguments; for diagnostics %1, %2, ... are the arguments. The desktop program translates the
// template (context "Message") before it fills it; the command line fills it as it is.
const char* message_template(ErrorCode code);
const char* message_template(DiagnosticKind kind);

// Fills %1 .. %9 of a template with the arguments, which may come from a file, as plain_text(). A
// number without an argument stays as it is.
std::string fill_template(const std::string& text, const std::vector<std::string>& args);

// The whole English sentence: what, where, why, what to do.
std::string english(const Error& error);
std::string english(const Diagnostic& diagnostic);

}  // namespace vybeg
