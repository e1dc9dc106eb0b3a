#include "core/analysis/inspect.h"

#include "core/analysis/identify.h"
#include "core/analysis/prepare.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <utility>

namespace vybeg {

namespace {

// What the motion shows of the recording: no free decay, channels of one projection. None where an
// identification is impossible. Errors: interrupted.
Result<std::vector<Diagnostic>> verdicts_on(const Recording& recording,
                                            const SignalSettings& signal, const JobControl& job) {
    constexpr std::array verdicts{DiagnosticKind::no_free_decay, DiagnosticKind::no_free_decay_part,
                                  DiagnosticKind::same_projection, DiagnosticKind::mode_grows};
    IdentifySettings settings;
    settings.signal = signal;
    const Result<Identification> found = identify({&recording, 1}, settings, job.silent());
    if (!found) {
        const bool interrupted = found.error().code == ErrorCode::interrupted;
        return interrupted ? Result<std::vector<Diagnostic>>(found.error())
                           : std::vector<Diagnostic>{};
    }
    std::vector<Diagnostic> said;
    std::ranges::copy_if(found->fit.warnings, std::back_inserter(said), [&](const auto& warning) {
        return std::ranges::find(verdicts, warning.kind) != verdicts.end();
    });
    return said;
}

}  // namespace

Result<SampleFaults> inspect(const Recording& recording, const SignalSettings& settings,
                             const JobControl& job) {
    const Result<double> f0 = find_recording_carrier(recording, settings, job.silent());
    Result<SampleFaults> faults = check_recording(*recording.source, recording.rate_hz,
                                                  f0 ? std::optional(*f0) : std::nullopt, job);
    if (faults && f0) {
        const auto verdicts = TRY(verdicts_on(recording, settings, job));
        std::ranges::copy(verdicts, std::back_inserter(faults->findings));
    }
    if (faults) {
        std::vector<Diagnostic> all = recording.diagnostics;
        add_findings(faults->findings, all);
        faults->findings = std::move(all);
    }
    return faults;
}

}  // namespace vybeg
