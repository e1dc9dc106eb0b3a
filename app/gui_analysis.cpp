#include "app/gui_analysis.h"

#include "app/process_guard.h"
#include "core/analysis/analyse.h"
#include "core/analysis/idle_options.h"
#include "core/base/diagnostic.h"
#include "core/base/error.h"
#include "core/base/finding.h"
#include "core/output/output_paths.h"
#include "core/recording/open/open_recording.h"
#include "core/recording/samples/file_changes.h"
#include "ui/widgets/theme.h"

#include <algorithm>
#include <cstdio>
#include <memory>
#include <utility>

namespace vybeg::cli {

int fail(const Error& error) {
    std::fprintf(stderr, "vybeg: %s\n", english(error).c_str());
    return exit_status(error.code);
}

int ended(const Status& done) {
    return done ? 0 : fail(done.error());
}

void warn(const std::vector<Diagnostic>& diagnostics) {
    const std::vector<Finding> findings = findings_of(diagnostics);
    const std::size_t count = count_warnings(findings);
    for (std::size_t k = 0; k < std::min(count, most_shown); ++k) {
        std::fprintf(stderr, "vybeg: warning: %s\n", english(findings[k]).c_str());
    }
    if (count > most_shown) {
        std::fprintf(stderr, "vybeg: %zu more: vybeg-cli analyze --verbose\n", count - most_shown);
    }
}

Status check_request(const std::string& option, const std::string& output,
                     const std::vector<std::string>& inputs, const Settings& settings) {
    std::vector<InputPath> paths;
    paths.reserve(inputs.size());
    for (const std::string& input : inputs) {
        paths.push_back({input, "it is one of the recordings"});
    }
    TRY(check_outputs({{option, output, ""}}, paths));
    TRY(check_threads(settings.threads));
    warn(without_effect(settings));
    return {};
}

Result<Recording> open_warned(const std::string& input, const OpenOptions& options,
                              const JobControl& job) {
    Result<Recording> recording = open_recording(input, options, job);
    if (recording) {
        warn(without_effect(options, *recording));
    }
    return recording;
}

Result<Analysis> analyse_warned(const Recording& recording, const Settings& settings,
                                const JobControl& job) {
    Result<Analysis> analysis = analyse(recording, settings, job);
    TRY(unchanged(recording));
    if (analysis) {
        warn(analysis->diagnostics);
    }
    return analysis;
}

ui::ShownAnalysis shown_analysis(const Recording& recording, Analysis analysis, int index) {
    const ui::CurveStyle style = ui::curveStyle(index);
    ui::ShownAnalysis shown;
    shown.id = static_cast<ui::AnalysisId>(index + 1);
    shown.name = QStringLiteral("n = %1").arg(analysis.plan.length);
    shown.recording = QString::fromStdString(recording.path.filename().string());
    shown.color = style.color;
    shown.rate_hz = recording.rate_hz;
    shown.seconds_taken = analysis.timing.estimate_s;
    shown.analysis = std::make_shared<const Analysis>(std::move(analysis));
    return shown;
}

}  // namespace vybeg::cli
