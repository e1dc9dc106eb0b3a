#include "app/gui_report_set.h"

#include "app/gui_analysis.h"
#include "core/analysis/identify.h"
#include "core/analysis/inspect.h"
#include "core/recording/samples/file_changes.h"
#include "core/track/events.h"
#include "ui/resonator/conditions_text.h"

#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace vybeg::cli {

namespace {

// The recordings with their check and their analysis.
struct Analysed {
    std::vector<Recording> recordings;
    std::vector<std::string> hashes;
    ui::ReportContent content;
};

Status add_recording(const ListedRecording& listed, const Settings& settings, const JobControl& job,
                     Analysed& all) {
    auto recording = TRY(open_warned(listed.path.string(), listed.open, job));
    const auto hash = TRY(recording_sha256(recording, job));
    auto analysis = TRY(analyse_warned(recording, settings, job));
    auto faults = TRY(inspect(recording, settings, job));
    ui::ReportRecording told = ui::reportRecording(recording, QString::fromStdString(hash));
    told.check = std::move(faults.findings);
    const std::size_t index = all.recordings.size();
    const TrackSummary means = analysis.means;
    std::vector<Event> events = find_events(analysis.track);
    all.content.analyses.push_back(
        {shown_analysis(recording, std::move(analysis), static_cast<int>(index)), index, means,
         std::move(events)});
    all.content.recordings.push_back(std::move(told));
    all.recordings.push_back(std::move(recording));
    all.hashes.push_back(hash);
    return {};
}

Status add_resonator(const IdentifySettings& settings, const JobControl& job, Analysed& all) {
    TRY(check_distinct(all.recordings, all.hashes));
    Result<Identification> found = identify(all.recordings, settings, job);
    for (const Recording& recording : all.recordings) {
        TRY(unchanged(recording));
    }
    if (!found) {
        if (found.error().code == ErrorCode::interrupted) {
            return found.error();
        }
        all.content.not_identified = found.error();
        return {};
    }
    auto outcome = std::make_shared<ui::ResonatorOutcome>();
    for (std::size_t k = 0; k < all.recordings.size(); ++k) {
        const Recording& recording = all.recordings[k];
        outcome->inputs.push_back({recording.path.filename().string(), all.hashes[k],
                                   recording.start, recording.seconds(), recording.rate_hz,
                                   found->runs[k].f0_hz});
    }
    outcome->identification = std::move(*found);
    all.content.outcome = std::move(outcome);
    return {};
}

}  // namespace

Result<ui::ReportContent> report_of_set(const MeasurementSet& set,
                                        const std::vector<std::string>& other_columns,
                                        const Settings& track, const ui::ReportTitle& title,
                                        const JobControl& job) {
    TRY(check_conditions(set));
    Analysed all;
    for (std::size_t k = 0; k < set.recordings.size(); ++k) {
        Settings settings = track;
        static_cast<SignalSettings&>(settings) = set.settings.signal_of(k);
        settings.threads = set.settings.threads;
        TRY(add_recording(set.recordings[k], settings, job, all));
        all.content.recordings.back().conditions =
            ui::conditionsText(set.recordings[k], other_columns);
    }
    TRY(add_resonator(set.settings, job, all));
    all.content.units.angle = ui::AngleUnit::degrees;
    all.content.title = ui::titleOf(set, title);
    if (all.content.title.date.isEmpty()) {
        all.content.title.date = ui::measuredOn(all.content.recordings);
    }
    return std::move(all.content);
}

}  // namespace vybeg::cli
