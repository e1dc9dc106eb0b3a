#include "app/gui_report_set.h"

#include "app/gui_analysis.h"
#include "core/analysis/inspect.h"
#include "core/batch/identify_set.h"
#include "core/track/events.h"
#include "ui/resonator/conditions_text.h"

#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace vybeg::cli {

namespace {

// A recording with its check and its analysis.
Status add_recording(const Recording& recording, const Settings& settings, const JobControl& job,
                     ui::ReportContent& content) {
    auto analysis = TRY(analyse_warned(recording, settings, job));
    auto faults = TRY(inspect(recording, settings, job));
    ui::ReportRecording told = ui::reportRecording(recording, {});
    told.check = std::move(faults.findings);
    const std::size_t index = content.recordings.size();
    const TrackSummary means = analysis.means;
    std::vector<Event> events = find_events(analysis.track);
    content.analyses.push_back(
        {shown_analysis(recording, std::move(analysis), static_cast<int>(index)), index, means,
         std::move(events)});
    content.recordings.push_back(std::move(told));
    return {};
}

Status add_resonator(OpenSet& open, const JobControl& job, ui::ReportContent& content) {
    TRY(read_contents(open, job.stop_token()));
    for (std::size_t k = 0; k < open.recordings.size(); ++k) {
        content.recordings[k].sha256 = QString::fromStdString(open.set.recordings[k].sha256);
    }
    Result<SetResult> found = identify_set(open, {}, {}, job);
    for (const RecordingRef& log : open.set.recordings) {
        if (open.set.settings.logs.given()) {
            content.recordings.push_back(ui::reportLog(log));
            content.recordings.back().conditions = ui::conditionsText(log);
        }
    }
    if (found) {
        content.outcome = std::make_shared<ui::ResonatorOutcome>(
            ui::ResonatorOutcome{std::move(*found), {}, 0, {}});
        return {};
    }
    if (found.error().code == ErrorCode::interrupted ||
        found.error().code == ErrorCode::file_changed) {
        return found.error();
    }
    content.not_identified = found.error();
    return {};
}

}  // namespace

Result<ui::ReportContent> report_of_set(const MeasurementSet& set, const Settings& track,
                                        const ui::ReportTitle& title, const JobControl& job) {
    TRY(check_conditions(set));
    OpenSet open;
    open.set = set;
    ui::ReportContent content;
    // Logs have no samples to analyse.
    const std::size_t recordings = set.settings.logs.given() ? 0 : set.recordings.size();
    for (std::size_t k = 0; k < recordings; ++k) {
        Settings settings = track;
        static_cast<SignalSettings&>(settings) = set.settings.signal_of(k);
        settings.threads = set.settings.threads;
        const RecordingRef& listed = set.recordings[k];
        auto recording = TRY(open_warned(listed.path.string(), listed.open, job));
        open.recordings.push_back(std::move(recording));
        TRY(add_recording(open.recordings.back(), settings, job, content));
        content.recordings.back().conditions = ui::conditionsText(listed);
    }
    TRY(add_resonator(open, job, content));
    content.units.angle = ui::AngleUnit::degrees;
    content.title = ui::titleOf(set, title);
    if (content.title.date.isEmpty()) {
        content.title.date = ui::measuredOn(content.recordings);
    }
    return content;
}

}  // namespace vybeg::cli
