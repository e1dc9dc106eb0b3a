#pragma once

#include "core/base/message_arg.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace vybeg {

// A note or warning about a recording or an analysis, which does not stop it, by the rows of
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

// The name of a kind in JSON, e.g. "time-gap".
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

// Diagnostics and the recording that they concern; empty: the result, or the command.
using NamedWarnings = std::pair<std::string, std::vector<Diagnostic>>;

// One line of a list of warnings: the diagnostics of one kind.
struct Finding {
    Diagnostic diagnostic;           // the first
    std::vector<std::string> about;  // names of recordings, each once
    std::vector<Diagnostic> more;    // those that differ from the first and from each other
    std::int64_t count = 0;          // diagnostics
    std::int64_t frames = 0;         // samples of all
};

// Longest list that is shown unasked.
inline constexpr std::size_t most_shown = 3;

// The worst first; of one severity in the order given.
std::vector<Finding> findings_of(std::span<const NamedWarnings> all);
std::vector<Finding> findings_of(const std::vector<Diagnostic>& diagnostics);

// How many of them are no notes; they come first.
std::size_t count_warnings(std::span<const Finding> findings);

// Codes of those that are no notes, with ";" between.
std::string warning_kinds(std::span<const Finding> findings);

// "a.wav, b.wav"; of more than most_shown names the first with the number of the others.
std::string about_text(const Finding& finding);

// "a.wav: 12 samples are missing at 3 s. (And 20 more places; 240 samples in all.)"
std::string english(const Finding& finding);

}  // namespace vybeg
