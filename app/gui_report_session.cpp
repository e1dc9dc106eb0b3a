#include "app/gui_report_session.h"

#include "app/gui_analysis.h"
#include "core/base/messages.h"
#include "ui/document/document.h"
#include "ui/plots/track_view.h"
#include "ui/report/document_report.h"
#include "ui/report/report_writer.h"
#include "ui/session/session_keeper.h"

#include <QEventLoop>
#include <QTimer>

#include <algorithm>
#include <cstdio>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

namespace vybeg::cli {

namespace {

using namespace vybeg::ui;

constexpr int tick_ms = 20;

// Lets the session work until `done`; false after an interruption.
bool wait_until(const std::function<bool()>& done, const std::stop_token& stop) {
    QEventLoop loop;
    QTimer tick;
    QObject::connect(&tick, &QTimer::timeout, &loop, [&] {
        if (done() || stop.stop_requested()) {
            loop.quit();
        }
    });
    tick.start(tick_ms);
    loop.exec();
    return !stop.stop_requested();
}

// Whether every recording has its hash and its check, and no analysis and no drift is under way.
bool is_whole(const Document& document) {
    return !document.busy() && !document.drift().computing() &&
           std::ranges::all_of(document.recordings(), [](const RecordingEntry& entry) {
               return entry.recording && !entry.sha256.isEmpty() && entry.faults;
           });
}

// Sets that the session brings without a result that still holds.
void identify_the_rest(Document& document) {
    for (const RecordingSet& set : document.sets().all()) {
        if ((ui::isOfLogs(set) || !set.recordings.empty()) && !document.sets().outcome(set)) {
            document.sets().identifySet(set.id);
        }
    }
}

// The set, or all sets, or without one the current recording.
std::optional<ReportSubject> subject_of(const Document& document) {
    const std::vector<ReportSubject> subjects = reportSubjects(document);
    const auto sets = std::ranges::count_if(
        subjects, [](const ReportSubject& each) { return each.set != ui::SetId::none; });
    const auto wanted = std::ranges::find_if(subjects, [sets](const ReportSubject& each) {
        return sets > 1 ? each.all_sets : sets == 1 ? each.set != ui::SetId::none : true;
    });
    return wanted == subjects.end() ? std::nullopt : std::optional(*wanted);
}

std::vector<std::string> recording_files(const ReportRequest& request, const Document& document) {
    std::vector<std::string> files = request.inputs;
    for (const RecordingEntry& entry : document.recordings()) {
        files.push_back(entry.path.toStdString());
    }
    return files;
}

}  // namespace

int write_session_report(const ReportRequest& request, std::stop_token stop) {
    Document document;
    TrackView tracks;
    SessionKeeper session(document, tracks);
    session.end();  // without copies: nothing of it is changed
    DisplayUnits units;
    QObject::connect(&session, &SessionKeeper::unitsWanted,
                     [&units](const DisplayUnits& wanted) { units = wanted; });
    QObject::connect(&document, &Document::reported, [](const Message& message) {
        std::fprintf(stderr, "vybeg: %s\n", qUtf8Printable(message.text()));
    });
    const Error interrupted{ErrorCode::interrupted, {}, {}};
    if (!session.openSession(QString::fromStdString(request.inputs.front()))) {
        return exit_status(ErrorCode::format_damaged);  // the message has told why
    }
    const auto ready = [&] { return !session.isOpening() && is_whole(document); };
    if (!wait_until(ready, stop)) {
        return fail(interrupted);
    }
    if (const Status possible = check_request("--report", request.report,
                                              recording_files(request, document), request.settings);
        !possible) {
        return fail(possible.error());
    }
    identify_the_rest(document);
    if (!wait_until(ready, stop)) {
        return fail(interrupted);
    }
    const std::optional<ReportSubject> subject = subject_of(document);
    if (!subject) {
        return fail(
            {ErrorCode::setting_invalid,
             "",
             {"--report", request.inputs.front(),
              "none of the session's recordings is there and analysed, and no log has a drift"}});
    }
    const ReportTitle otherwise =
        completed(request.title, titleOf(document.dossier().dossier().gyro));
    std::vector<ReportContent> contents = reportContentsOf(document, *subject);
    for (ReportContent& content : contents) {
        content.units = units;
        content.summary = request.summary;
        content.title = completed(content.title, otherwise);
    }
    ReportWriter writer;
    std::optional<Status> written;
    writer.write(contents, subject->name, QString::fromStdString(request.report),
                 [&written](const Status& status) { written = status; });
    if (!wait_until([&written] { return written.has_value(); }, stop)) {
        return fail(interrupted);
    }
    return *written ? 0 : fail(written->error());
}

}  // namespace vybeg::cli
