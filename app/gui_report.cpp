#include "app/gui_report.h"

#include "app/gui_analysis.h"
#include "core/analysis/identify.h"
#include "core/analysis/inspect.h"
#include "core/output/file_ending.h"
#include "core/output/output_file.h"
#include "core/recording/samples/file_changes.h"
#include "core/track/events.h"
#include "ui/report/report_pdf.h"

#include <QCoreApplication>

#include <memory>
#include <utility>

namespace vybeg::cli {

namespace {

// The recordings with their check and their analysis.
struct Analysed {
    std::vector<Recording> recordings;
    std::vector<std::string> hashes;
    ui::ReportContent content;
};

Status add_recording(const std::string& input, const ReportRequest& request, const JobControl& job,
                     Analysed& all) {
    Result<Recording> recording = open_warned(input, request.open, job);
    if (!recording) {
        return recording.error();
    }
    const Result<std::string> hash = recording_sha256(*recording, job);
    if (!hash) {
        return hash.error();
    }
    Result<Analysis> analysis = analyse_warned(*recording, request.settings, job);
    if (!analysis) {
        return analysis.error();
    }
    Result<SampleFaults> faults = inspect(*recording, request.settings, job);
    if (!faults) {
        return faults.error();
    }
    ui::ReportRecording told = ui::reportRecording(*recording, QString::fromStdString(*hash));
    told.check = std::move(faults->findings);
    const std::size_t index = all.recordings.size();
    const TrackSummary means = analysis->means;
    std::vector<Event> events = find_events(analysis->track);
    all.content.runs.push_back({run_of(*recording, std::move(*analysis), static_cast<int>(index)),
                                index, means, std::move(events)});
    all.content.recordings.push_back(std::move(told));
    all.recordings.push_back(std::move(*recording));
    all.hashes.push_back(*hash);
    return {};
}

// One resonator behind all recordings. What cannot be identified has a place in the report; what
// the engineer has to mend is an error.
Status add_resonator(const ReportRequest& request, const JobControl& job, Analysed& all) {
    if (Status distinct = check_distinct(all.recordings, all.hashes); !distinct) {
        return distinct;
    }
    IdentifySettings settings;
    settings.signal = request.settings;
    settings.tolerance = request.tolerance;
    settings.threads = request.settings.threads;
    Result<Identification> found = identify(all.recordings, settings, job);
    for (const Recording& recording : all.recordings) {
        if (Status still = unchanged(recording); !still) {
            return still;
        }
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

Status check_ending(const std::string& path) {
    const std::string ending = file_ending(path);
    return ending == ".pdf" ? Status()
                            : Error{ErrorCode::setting_invalid,
                                    "",
                                    {"--report", path, "a report is a PDF document: name it .pdf"}};
}

}  // namespace

int write_report(const ReportRequest& request, std::stop_token stop) {
    if (const Status is_pdf = check_ending(request.report); !is_pdf) {
        return fail(is_pdf.error());
    }
    if (const Status possible =
            check_request("--report", request.report, request.inputs, request.settings);
        !possible) {
        return fail(possible.error());
    }
    const JobControl job(stop);
    Analysed all;
    for (const std::string& input : request.inputs) {
        if (const Status added = add_recording(input, request, job, all); !added) {
            return fail(added.error());
        }
    }
    if (const Status identified = add_resonator(request, job, all); !identified) {
        return fail(identified.error());
    }
    all.content.units.angle = ui::AngleUnit::degrees;
    all.content.title.date = ui::measuredOn(all.content.recordings);
    const QByteArray pdf = ui::reportPdf(
        all.content, QStringLiteral("Vybeg ") + QCoreApplication::applicationVersion(),
        QDateTime::currentDateTime());
    const Status written =
        write_file(request.report, {pdf.constData(), static_cast<std::size_t>(pdf.size())}, job);
    return written ? 0 : fail(written.error());
}

}  // namespace vybeg::cli
