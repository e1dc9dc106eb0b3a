#include "core/base/diagnostic.h"

#include <array>

namespace vybeg {

MessageRow message_row(DiagnosticKind kind) {
    constexpr int note = static_cast<int>(Severity::note);
    constexpr int warning = static_cast<int>(Severity::warning);
    constexpr int serious = static_cast<int>(Severity::serious);
    static constexpr std::array rows{
#define ROW(kind, severity, sentence) MessageRow{#kind, severity, sentence},
#include "core/base/diagnostic_rows.h"
#undef ROW
    };
    return row_at(rows, static_cast<std::size_t>(kind));
}

std::string kind_name(DiagnosticKind kind) {
    return message_row(kind).name();
}

Severity severity(DiagnosticKind kind) {
    return static_cast<Severity>(message_row(kind).grade);
}

std::string severity_name(Severity severity) {
    switch (severity) {
        case Severity::note: return "note";
        case Severity::warning: return "warning";
        case Severity::serious: return "serious";
    }
    return "";
}

std::string english(const Diagnostic& diagnostic) {
    return english(message_row(diagnostic.kind), diagnostic.args);
}

}  // namespace vybeg
