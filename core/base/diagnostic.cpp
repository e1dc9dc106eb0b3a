#include "core/base/diagnostic.h"

#include "core/base/plain_text.h"

#include <algorithm>
#include <array>
#include <functional>

namespace vybeg {
namespace {

void add(const std::string& about, const Diagnostic& diagnostic, Finding& finding) {
    // Places first: there may be ten thousand gaps.
    const auto same = [&diagnostic](const Diagnostic& each) {
        return each.first_frame == diagnostic.first_frame && each == diagnostic;
    };
    if (finding.count == 0) {
        finding.diagnostic = diagnostic;
    } else if (!same(finding.diagnostic) && std::ranges::none_of(finding.more, same)) {
        finding.more.push_back(diagnostic);
    }
    if (!about.empty() && std::ranges::find(finding.about, about) == finding.about.end()) {
        finding.about.push_back(about);
    }
    ++finding.count;
    finding.frames += diagnostic.count;
}

// What the sentence of the first leaves out; empty: nothing.
std::string rest_text(const Finding& finding) {
    if (finding.more.empty()) {
        return {};
    }
    const std::string others = std::to_string(finding.more.size());
    if (finding.diagnostic.first_frame < 0) {
        return " (And " + others + " more of the kind.)";
    }
    return " (And " + others + (finding.more.size() == 1 ? " more place" : " more places") +
           (finding.frames > 0 ? "; " + std::to_string(finding.frames) + " samples in all.)"
                               : ".)");
}

}  // namespace

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
    constexpr std::array names{"note", "warning", "serious"};
    return names[static_cast<std::size_t>(severity)];
}

std::string english(const Diagnostic& diagnostic) {
    return english(message_row(diagnostic.kind), diagnostic.args);
}

std::vector<Finding> findings_of(std::span<const NamedWarnings> all) {
    std::vector<Finding> findings;
    for (const auto& [about, diagnostics] : all) {
        for (const Diagnostic& diagnostic : diagnostics) {
            const auto same = std::ranges::find(findings, diagnostic.kind, [](const Finding& each) {
                return each.diagnostic.kind;
            });
            add(about, diagnostic, same != findings.end() ? *same : findings.emplace_back());
        }
    }
    std::ranges::stable_sort(findings, std::ranges::greater(),
                             [](const Finding& each) { return severity(each.diagnostic.kind); });
    return findings;
}

std::vector<Finding> findings_of(const std::vector<Diagnostic>& diagnostics) {
    const NamedWarnings all{{}, diagnostics};
    return findings_of(std::span(&all, 1));
}

std::size_t count_warnings(std::span<const Finding> findings) {
    return static_cast<std::size_t>(std::ranges::count_if(findings, [](const Finding& each) {
        return severity(each.diagnostic.kind) != Severity::note;
    }));
}

std::string warning_kinds(std::span<const Finding> findings) {
    return joined(findings.first(count_warnings(findings)), ";",
                  [](const Finding& finding) { return kind_name(finding.diagnostic.kind); });
}

std::string about_text(const Finding& finding) {
    const std::string text =
        joined(std::span(finding.about).first(std::min(finding.about.size(), most_shown)), ", ",
               plain_text);
    return finding.about.size() > most_shown
               ? text + ", +" + std::to_string(finding.about.size() - most_shown)
               : text;
}

std::string english(const Finding& finding) {
    std::string text = about_text(finding);
    text += text.empty() ? "" : ": ";
    text += english(finding.diagnostic);
    return text + rest_text(finding);
}

}  // namespace vybeg
