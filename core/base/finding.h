#pragma once

#include "core/base/diagnostic.h"

#include <cstddef>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace vybeg {

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
