#include "app/gui_drawing.h"

#include "core/analysis/analyse.h"
#include "core/analysis/analysis.h"
#include "core/analysis/identify.h"
#include "core/analysis/ignored_options.h"
#include "core/analysis/setting_table.h"
#include "core/base/error.h"
#include "core/base/job_control.h"
#include "core/base/read_value.h"
#include "core/base/setting_rows.h"
#include "core/batch/batch_sets.h"
#include "core/batch/identify_set.h"
#include "core/output/output_file.h"
#include "core/recording/open/open_recording.h"
#include "core/recording/samples/open_table.h"
#include "core/recording/samples/recording.h"
#include "ui/document/document.h"
#include "ui/plots/plot_stack.h"
#include "ui/plots/track_view.h"
#include "ui/report/report_document.h"
#include "ui/session/session_keeper.h"
#include "ui/values/shown_analysis.h"
#include "ui/widgets/theme.h"
#include "ui/words/error_text.h"

#include <QEventLoop>
#include <QFileInfo>
#include <QTimer>

#include <algorithm>
#include <cstdio>
#include <functional>
#include <iterator>
#include <memory>
#include <optional>
#include <utility>

namespace vybeg::cli {

namespace {

constexpr LogOptions to_people{.program = "vybeg", .all_by = "vybeg-cli analyze --verbose"};

}  // namespace

int fail(const Error& error) {
    return Log(to_people).fail(error);
}

int ended(const Status& done) {
    return done ? 0 : fail(done.error());
}

void warn(const std::vector<Diagnostic>& diagnostics) {
    Log(to_people).warnings(diagnostics);
}

namespace {

// Checks what can be checked before the first recording is opened, and warns of settings without
// effect. Errors: setting_invalid.
Status check_request(const std::string& option, const std::string& output,
                     const std::vector<InputPath>& inputs, const Settings& settings) {
    TRY(check_outputs({{option, output, ""}}, inputs));
    warn(without_effect(settings));
    return {};
}

// With its warnings. Errors: those of analyse(), file_changed.
Result<Analysis> analyse_warned(const Recording& recording, const Settings& settings,
                                const JobControl& job) {
    Result<Analysis> analysis = analyse(recording, settings, job);
    TRY(unchanged(recording));
    if (analysis) {
        warn(analysis->diagnostics);
    }
    return analysis;
}

// In the colour of that number; its name is the window.
ui::AnalysisEntry shown_analysis(const Recording& recording, Analysis analysis, std::size_t index) {
    ui::AnalysisEntry entry;
    entry.shown = ui::shownOf(recording);
    entry.shown.id = static_cast<ui::AnalysisId>(index + 1);
    entry.shown.name = QStringLiteral("n = %1").arg(analysis.plan.length);
    entry.shown.color = ui::curveStyle(static_cast<int>(index)).color;
    entry.take(ui::outcomeOf(std::move(analysis)));
    return entry;
}

// The settings of the columns of one recording.
std::vector<Settings> columns_of(const GuiRequest& request) {
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

Status check_pdf(const std::string& path) {
    return file_ending(path) == ".pdf"
               ? Status()
               : refused_value("--report", path, "a report is a PDF document: name it .pdf");
}

bool is_session(const std::string& input) {
    return ui::SessionKeeper::isSession(QString::fromStdString(input));
}

// Of options given beside a session.
template <class S>
void warn_beside_session(const std::vector<SettingRow<S>>& rows, const S& told) {
    for (const SettingRow<S>& row : rows) {
        if (row.name != "threads" && row.text(told) != row.text(S())) {
            warn({{DiagnosticKind::option_without_effect,
                   {row.option(), "a session has settings of its own"}}});
        }
    }
}

Status check_no_session(const std::vector<std::string>& inputs) {
    for (const std::string& input : inputs) {
        if (is_session(input)) {
            return refused_value("--report", input,
                                 "a session is a report of its own: name no other file");
        }
    }
    return {};
}

Result<MeasurementList> wanted_sets(const GuiRequest& request) {
    IdentifySettings settings;
    settings.signal = request.settings;
    settings.tolerance = request.identify.tolerance;
    settings.threads = request.settings.threads;
    Log log(to_people);
    return sets_of(request, settings, log);
}

std::vector<InputPath> files_of(const GuiRequest& request,
                                const std::vector<MeasurementSet>& sets) {
    std::vector<InputPath> files{{request.list, "it is one of the recordings"}};
    for (const MeasurementSet& set : sets) {
        for (const RecordingRef& listed : set.recordings) {
            add_recording_files(files, listed.path, listed.open);
        }
    }
    return files;
}

// With its check and its analysis in the colour of that number.
Result<ui::ReportRecording> reported(const Recording& recording, const RecordingRef& listed,
                                     const Settings& settings, std::size_t index,
                                     const JobControl& job) {
    warn(without_effect(listed.open, recording));
    auto analysis = TRY(analyse_warned(recording, settings, job));
    auto faults = TRY(inspect(recording, settings, job));
    ui::ReportRecording told{listed, ui::formatText(recording.format)};
    told.check = std::move(faults.findings);
    told.analyses.push_back(shown_analysis(recording, std::move(analysis), index));
    return told;
}

Status add_resonator(const OpenSet& open, const JobControl& job, ui::ReportContent& content) {
    Result<SetResult> found = identify_set(open, {}, {}, job);
    if (open.set.settings.logs.given()) {
        for (const RecordingRef& log : open.set.recordings) {
            content.recordings.push_back({log});
        }
    }
    if (found) {
        content.outcome = std::make_shared<SetResult>(std::move(*found));
        return {};
    }
    if (found.error().code == ErrorCode::interrupted ||
        found.error().code == ErrorCode::file_changed) {
        return found.error();
    }
    content.not_identified = found.error();
    return {};
}

// What a report shows of a set, computed from its recordings: checks, analyses in the windows of
// `track` with the set's signals, identification. What cannot be identified has its reason in it.
// Conditions of the set take precedence over `title`. Warnings go to standard error. Errors:
// those of open_set(), analyse() and inspect(), file_changed, interrupted.
Result<ui::ReportContent> report_of_set(const MeasurementSet& set, const Settings& track,
                                        const ui::ReportTitle& title, const JobControl& job) {
    const auto open = TRY(open_set(set, "", job.stop_token()));
    ui::ReportContent content;
    for (std::size_t k = 0; k < open.recordings.size(); ++k) {
        Settings settings = track;
        static_cast<SignalSettings&>(settings) = set.settings.signal_of(k);
        settings.threads = set.settings.threads;
        auto told = TRY(reported(open.recordings[k], open.set.recordings[k], settings, k, job));
        content.recordings.push_back(std::move(told));
    }
    TRY(add_resonator(open, job, content));
    content.units.angle = ui::AngleUnit::degrees;
    content.title = ui::titleOf(set, title);
    if (content.title.date.isEmpty()) {
        content.title.date = ui::measuredOn(content.recordings);
    }
    return content;
}

// Set by set: only texts and figures stay in memory. A single set has no chapter; where it fails,
// the report does.
Result<QByteArray> pdf_of(const GuiRequest& request, const MeasurementList& list,
                          const JobControl& job) {
    std::vector<ui::ReportChapter> chapters;
    std::vector<ui::ReportFigure> figures;
    ui::DisplayUnits units;
    units.angle = ui::AngleUnit::degrees;
    const bool one = list.sets.size() == 1;
    for (const MeasurementSet& set : list.sets) {
        Result<ui::ReportContent> content =
            report_of_set(set, request.settings, request.title, job);
        if (!content) {
            if (one || ends_all(content.error().code)) {
                return content.error();
            }
            (void)fail(content.error());
            ui::ReportContent without;
            without.title = ui::titleOf(set, request.title);
            without.units = units;
            without.not_identified = content.error();
            content = std::move(without);
        }
        content->summary = request.summary;
        if (one) {
            return ui::reportPdf(ui::reportTextOf(*content), ui::drawnFigures(*content));
        }
        content->set = QString::fromStdString(set.name);
        content->chapter = static_cast<int>(chapters.size()) + 1;
        chapters.push_back(ui::chapterOf(*content));
        std::ranges::move(ui::drawnFigures(*content), std::back_inserter(figures));
    }
    const QString about = QFileInfo(QString::fromStdString(request.list)).fileName();
    return ui::reportPdf(ui::reportTextOf(about, chapters, units), figures);
}

using namespace vybeg::ui;

constexpr int tick_ms = 20;

// Lets the session work until `done`. Errors: interrupted.
Status wait_until(const std::function<bool()>& done, const std::stop_token& stop) {
    QEventLoop loop;
    QTimer tick;
    QObject::connect(&tick, &QTimer::timeout, &loop, [&] {
        if (done() || stop.stop_requested()) {
            loop.quit();
        }
    });
    tick.start(tick_ms);
    loop.exec();
    return stop.stop_requested() ? Status(Error{ErrorCode::interrupted, {}, {}}) : Status();
}

// Sets that the session brings without a result that still holds.
void identify_the_rest(Document& document) {
    for (const RecordingSet& set : document.sets().all()) {
        if (ui::hasMembers(set) && !document.sets().outcome(set)) {
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

std::vector<InputPath> recording_files(const GuiRequest& request, const Document& document) {
    std::vector<InputPath> files;
    add_recording_files(files, request.inputs.front(), {});
    for (const RecordingEntry& entry : document.recordings()) {
        add_recording_files(files, entry.path.toStdString(), {});
    }
    return files;
}

// The session is opened and computed without a window; its set, or all of its sets, are the report,
// without a set its current recording. Fields missing in the request's title are those of the
// session's gyro.
Result<int> write_session_report(const GuiRequest& request, std::stop_token stop) {
    warn_beside_session(analysis_settings(), request.settings);
    warn_beside_session(open_settings(), request.open);
    warn_beside_session(identify_settings(), request.identify);
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
    if (!session.openSession(QString::fromStdString(request.inputs.front()))) {
        return exit_status(ErrorCode::format_damaged);  // the message has the reason
    }
    const auto ready = [&] { return !session.isOpening() && !document.working(); };
    TRY(wait_until(ready, stop));
    TRY(check_request("--report", request.report, recording_files(request, document),
                      request.settings));
    if (const auto lacking = session.lackingSet()) {
        return refused_value("--report", request.inputs.front(),
                             "a recording of the set " + lacking->toStdString() +
                                 " is not there, or cannot be read: put it back, or take it out of "
                                 "the set");
    }
    identify_the_rest(document);
    TRY(wait_until(ready, stop));
    const std::optional<ReportSubject> subject = subject_of(document);
    if (!subject) {
        return refused_value(
            "--report", request.inputs.front(),
            "none of the session's recordings is there and analysed, and no log has a drift");
    }
    const ReportTitle usual = completed(request.title, titleOf(document.dossier().dossier().gyro));
    std::vector<ReportContent> contents = reportContentsOf(document, *subject, usual);
    for (ReportContent& content : contents) {
        content.units = units;
        content.summary = request.summary;
    }
    ReportWriter writer;
    std::optional<Status> written;
    writer.write(contents, subject->name, QString::fromStdString(request.report),
                 [&written](const Status& status) { written = status; });
    TRY(wait_until([&written] { return written.has_value(); }, stop));
    return ended(*written);
}

Status write_report_of_files(const GuiRequest& request, std::stop_token stop) {
    TRY(check_no_session(request.inputs));
    const auto list = TRY(wanted_sets(request));
    TRY(check_request("--report", request.report, files_of(request, list.sets), request.settings));
    const JobControl job(std::move(stop));
    const auto pdf = TRY(pdf_of(request, list, job));
    return write_file(request.report, {pdf.constData(), static_cast<std::size_t>(pdf.size())}, job);
}

// The exit status.
Result<int> report_status(const GuiRequest& request, std::stop_token stop) {
    TRY(check_pdf(request.report));
    if (request.inputs.size() == 1 && request.list.empty() && is_session(request.inputs.front())) {
        return write_session_report(request, std::move(stop));
    }
    TRY(write_report_of_files(request, std::move(stop)));
    return 0;
}

}  // namespace

Status draw_figure(const GuiRequest& request, std::stop_token stop) {
    std::vector<InputPath> files;
    for (const std::string& input : request.inputs) {
        add_recording_files(files, input, request.open);
    }
    TRY(check_request("--figure", request.figure, files, request.settings));
    const JobControl job(stop);
    std::vector<ui::FigureColumn> columns;
    for (const std::string& input : request.inputs) {
        const auto recording = TRY(open_recording(input, request.open, job));
        warn(without_effect(request.open, recording));
        for (const Settings& settings : columns_of(request)) {
            auto analysis = TRY(analyse_warned(recording, settings, job));
            ui::ShownAnalysis shown =
                shown_analysis(recording, std::move(analysis), columns.size()).shown;
            const QString title = request.inputs.size() > 1
                                      ? QStringLiteral("%1, %2").arg(shown.recording, shown.name)
                                      : shown.name;
            columns.push_back({title, std::move(shown)});
        }
    }
    if (stop.stop_requested()) {
        return Error{ErrorCode::interrupted, {}, {}};
    }
    const ui::Figure figure = ui::articleFigure(columns);
    return ui::writeDrawing(figure.draw, {figure.size}, QString::fromStdString(request.figure));
}

int write_report(const GuiRequest& request, std::stop_token stop) {
    const Result<int> status = report_status(request, std::move(stop));
    return status ? *status : fail(status.error());
}

}  // namespace vybeg::cli
