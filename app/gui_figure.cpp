#include "app/gui_figure.h"

#include "app/analysis_options.h"
#include "app/output_paths.h"
#include "app/process_guard.h"
#include "core/analysis/analyse.h"
#include "core/analysis/analysis.h"
#include "core/analysis/settings.h"
#include "core/base/messages.h"
#include "core/recording/open/open_recording.h"
#include "core/recording/samples/file_changes.h"
#include "ui/plots/figure.h"
#include "ui/widgets/theme.h"

#include <cstdio>
#include <memory>

namespace vybeg::cli {

namespace {

int fail(const Error& error) {
    std::fprintf(stderr, "vybeg: %s\n", english(error).c_str());
    return exit_status(error.code);
}

void warn(const Diagnostic& diagnostic) {
    std::fprintf(stderr, "vybeg: warning: %s\n", english(diagnostic).c_str());
}

ui::FigureColumn column_of(const Recording& recording, Analysis analysis, bool name_the_file,
                           int index) {
    const QString file = QString::fromStdString(recording.path.filename().string());
    const QString window = QStringLiteral("n = %1").arg(analysis.plan.length);
    const ui::RunStyle style = ui::runStyle(index);
    ui::Run run;
    run.id = index + 1;
    run.name = window;
    run.recording = file;
    run.color = style.color;
    run.rate_hz = recording.rate_hz;
    run.seconds_taken = analysis.timing.estimate_s;
    run.analysis = std::make_shared<const Analysis>(std::move(analysis));
    return {name_the_file ? QStringLiteral("%1, %2").arg(file, window) : window, std::move(run)};
}

}  // namespace

int draw_figure(const FigureRequest& request, std::stop_token stop) {
    std::vector<InputPath> inputs;
    for (const std::string& input : request.inputs) {
        inputs.push_back({input, "it is one of the recordings"});
    }
    if (const Status possible = check_outputs({{"--figure", request.figure, ""}}, inputs);
        !possible) {
        return fail(possible.error());
    }
    if (const Status enough = check_threads(request.settings.threads); !enough) {
        return fail(enough.error());
    }
    for (const Diagnostic& diagnostic : without_effect(request.settings)) {
        warn(diagnostic);
    }
    const JobControl job(stop);
    std::vector<ui::FigureColumn> columns;
    for (const std::string& input : request.inputs) {
        const Result<Recording> recording = open_recording(input, request.open, job);
        if (!recording) {
            return fail(recording.error());
        }
        for (const Diagnostic& diagnostic : without_effect(request.open, *recording)) {
            warn(diagnostic);
        }
        std::vector<Settings> wanted{request.settings};
        if (!request.windows.empty()) {
            wanted.clear();
            for (const std::int64_t window : request.windows) {
                Settings settings = request.settings;
                settings.window = window;
                settings.periods.reset();
                wanted.push_back(settings);
            }
        }
        for (const Settings& settings : wanted) {
            Result<Analysis> analysis = analyse(*recording, settings, job);
            if (const Status still = unchanged(*recording); !still) {
                return fail(still.error());
            }
            if (!analysis) {
                return fail(analysis.error());
            }
            for (const Diagnostic& diagnostic : analysis->diagnostics) {
                warn(diagnostic);
            }
            const int index = static_cast<int>(columns.size());
            columns.push_back(
                column_of(*recording, std::move(*analysis), request.inputs.size() > 1, index));
        }
    }
    if (stop.stop_requested()) {
        return fail({ErrorCode::interrupted, {}, {}});
    }
    const Status drawn =
        ui::writeDrawing(ui::figureDrawing(columns), {ui::figureSize(columns.size(), {})},
                         QString::fromStdString(request.figure));
    return drawn ? 0 : fail(drawn.error());
}

}  // namespace vybeg::cli
