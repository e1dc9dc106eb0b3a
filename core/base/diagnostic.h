#pragma once

#include "core/base/message_arg.h"

#include <cstdint>
#include <string>
#include <vector>

namespace vybeg {

// What deserves to be known about a recording or an analysis but does not stop it, by the rows of
// diagnostic_rows.h.
enum class DiagnosticKind {
#define ROW(kind, severity, sentence) kind,
#include "core/base/diagnostic_rows.h"
#undef ROW
};

// first_frame is -1 where the diagnostic has no place in the recording; count is in frames.
struct Diagnostic {
    DiagnosticKind kind{};
    std::vector<MessageArg> args;
    std::int64_t first_frame = -1;
    std::int64_t count = 0;

    friend bool operator==(const Diagnostic&, const Diagnostic&) = default;
};

// The name of a kind as it stands in JSON, e.g. "time-gap".
std::string kind_name(DiagnosticKind kind);

// Weight of a diagnostic: the worst are shown first.
enum class Severity {
    note,     // the numbers are unaffected
    warning,  // deviations are enlarged, or windows flagged
    serious   // numbers are refused, or may be off by more than their deviations
};
Severity severity(DiagnosticKind kind);

// Its name in JSON: "note", "warning" or "serious".
std::string severity_name(Severity severity);

MessageRow message_row(DiagnosticKind kind);

// The whole English sentence.
std::string english(const Diagnostic& diagnostic);

}  // namespace vybeg
