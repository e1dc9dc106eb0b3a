#include "core/analysis/inspect.h"

#include "core/analysis/recording_carrier.h"
#include "core/analysis/settings.h"

#include <algorithm>
#include <utility>

namespace vybeg {

Result<SampleFaults> inspect(const Recording& recording, const SignalSettings& settings,
                             const JobControl& job) {
    const Result<double> f0 = find_recording_carrier(recording, settings, job.silent());
    Result<SampleFaults> faults = check_recording(*recording.source, recording.rate_hz,
                                                  f0 ? std::optional(*f0) : std::nullopt, job);
    if (faults) {
        std::vector<Diagnostic> all = recording.diagnostics;
        add_findings(faults->findings, all);
        faults->findings = std::move(all);
    }
    return faults;
}

void add_findings(const std::vector<Diagnostic>& findings, std::vector<Diagnostic>& diagnostics) {
    const bool gaps_known = std::ranges::any_of(diagnostics, [](const Diagnostic& known) {
        return known.kind == DiagnosticKind::missing_samples ||
               known.kind == DiagnosticKind::time_gap ||
               known.kind == DiagnosticKind::gaps_inserted;
    });
    std::ranges::copy_if(findings, std::back_inserter(diagnostics), [&](const Diagnostic& found) {
        return found.kind != DiagnosticKind::missing_samples || !gaps_known;
    });
}

}  // namespace vybeg
