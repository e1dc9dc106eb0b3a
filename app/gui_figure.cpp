#include "app/gui_figure.h"

#include "app/gui_analysis.h"
#include "ui/plots/figure.h"

#include <utility>

namespace vybeg::cli {

namespace {

// The settings of the columns of one recording.
std::vector<Settings> columns_of(const FigureRequest& request) {
    if (request.windows.empty()) {
        return {request.settings};
    }
    std::vector<Settings> wanted;
    for (const std::int64_t window : request.windows) {
        Settings settings = request.settings;
        settings.window = window;
        settings.periods.reset();
        wanted.push_back(settings);
    }
    return wanted;
}

}  // namespace

Status draw_figure(const FigureRequest& request, std::stop_token stop) {
    TRY(check_request("--figure", request.figure, request.inputs, request.settings));
    const JobControl job(stop);
    std::vector<ui::FigureColumn> columns;
    for (const std::string& input : request.inputs) {
        const auto recording = TRY(open_warned(input, request.open, job));
        for (const Settings& settings : columns_of(request)) {
            auto analysis = TRY(analyse_warned(recording, settings, job));
            ui::ShownAnalysis shown =
                shown_analysis(recording, std::move(analysis), static_cast<int>(columns.size()));
            const QString title = request.inputs.size() > 1
                                      ? QStringLiteral("%1, %2").arg(shown.recording, shown.name)
                                      : shown.name;
            columns.push_back({title, std::move(shown)});
        }
    }
    if (stop.stop_requested()) {
        return Error{ErrorCode::interrupted, {}, {}};
    }
    return ui::writeDrawing(ui::figureDrawing(columns), {ui::figureSize(columns.size(), {})},
                            QString::fromStdString(request.figure));
}

}  // namespace vybeg::cli
