#include "app/gui_report.h"

#include "app/gui_analysis.h"
#include "app/gui_report_session.h"
#include "app/gui_report_set.h"
#include "core/base/messages.h"
#include "core/batch/list_sets.h"
#include "core/output/output_file.h"
#include "core/output/output_paths.h"
#include "ui/report/report_pdf.h"
#include "ui/session/session_keeper.h"

#include <QCoreApplication>
#include <QFileInfo>

#include <iterator>
#include <utility>

namespace vybeg::cli {

namespace {

Status check_pdf(const std::string& path) {
    return file_ending(path) == ".pdf"
               ? Status()
               : Error{ErrorCode::setting_invalid,
                       "",
                       {"--report", path, "a report is a PDF document: name it .pdf"}};
}

bool is_session(const std::string& input) {
    return ui::SessionKeeper::isSession(QString::fromStdString(input));
}

Status check_no_session(const std::vector<std::string>& inputs) {
    for (const std::string& input : inputs) {
        if (is_session(input)) {
            return Error{
                ErrorCode::setting_invalid,
                "",
                {"--report", input, "a session is a report of its own: name no other file"}};
        }
    }
    return {};
}

Result<MeasurementList> wanted_sets(const ReportRequest& request) {
    IdentifySettings settings;
    settings.signal = request.settings;
    settings.tolerance = request.tolerance;
    settings.threads = request.settings.threads;
    if (request.list.empty()) {
        MeasurementSet set{"", {}, settings};
        for (const std::string& name : request.inputs) {
            set.recordings.push_back({name, name, request.open, {}, {}});
        }
        return MeasurementList{{}, {std::move(set)}, {}};
    }
    Result<MeasurementList> list = read_measurement_list(request.list, {request.open, settings});
    if (!list) {
        return list.error();
    }
    warn(list->warnings);
    if (request.set.empty()) {
        return list;
    }
    auto named = TRY(set_named(*list, "--set", request.set));
    list->sets = {std::move(named)};
    return list;
}

std::vector<std::string> files_of(const ReportRequest& request,
                                  const std::vector<MeasurementSet>& sets) {
    std::vector<std::string> files;
    for (const MeasurementSet& set : sets) {
        for (const RecordingRef& listed : set.recordings) {
            files.push_back(listed.path.string());
        }
    }
    if (!request.list.empty()) {
        files.push_back(request.list);
    }
    return files;
}

// Faults that are no property of a set.
bool ends_report(ErrorCode code) {
    return code == ErrorCode::out_of_memory || code == ErrorCode::out_of_threads ||
           exit_status(code) == exit_status(ErrorCode::interrupted);
}

QString program_text() {
    return QStringLiteral("Vybeg ") + QCoreApplication::applicationVersion();
}

Result<QByteArray> pdf_of_one(const ReportRequest& request, const MeasurementList& list,
                              const JobControl& job) {
    auto content = TRY(report_of_set(list.sets.front(), request.settings, request.title, job));
    content.summary = request.summary;
    return ui::reportPdf(ui::reportTextOf(content, program_text(), ui::reportDay()),
                         ui::drawnFigures(content));
}

// Set by set: only texts and figures stay in memory.
Result<QByteArray> pdf_of_all(const ReportRequest& request, const MeasurementList& list,
                              const JobControl& job) {
    std::vector<ui::ReportChapter> chapters;
    std::vector<ui::ReportPicture> pictures;
    ui::DisplayUnits units;
    units.angle = ui::AngleUnit::degrees;
    for (const MeasurementSet& set : list.sets) {
        Result<ui::ReportContent> content =
            report_of_set(set, request.settings, request.title, job);
        if (!content) {
            if (ends_report(content.error().code)) {
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
        content->set = QString::fromStdString(set.name);
        content->chapter = static_cast<int>(chapters.size()) + 1;
        chapters.push_back(ui::chapterOf(*content));
        std::ranges::move(ui::drawnFigures(*content), std::back_inserter(pictures));
    }
    const QString about = QFileInfo(QString::fromStdString(request.list)).fileName();
    return ui::reportPdf(ui::reportTextOf(about, chapters, units, program_text(), ui::reportDay()),
                         pictures);
}

}  // namespace

int write_report(const ReportRequest& request, std::stop_token stop) {
    if (const Status is_pdf = check_pdf(request.report); !is_pdf) {
        return fail(is_pdf.error());
    }
    if (request.inputs.size() == 1 && request.list.empty() && is_session(request.inputs.front())) {
        return write_session_report(request, std::move(stop));
    }
    if (const Status possible = check_no_session(request.inputs); !possible) {
        return fail(possible.error());
    }
    const Result<MeasurementList> list = wanted_sets(request);
    if (!list) {
        return fail(list.error());
    }
    if (const Status possible = check_request("--report", request.report,
                                              files_of(request, list->sets), request.settings);
        !possible) {
        return fail(possible.error());
    }
    const JobControl job(stop);
    const Result<QByteArray> pdf =
        list->sets.size() == 1 ? pdf_of_one(request, *list, job) : pdf_of_all(request, *list, job);
    if (!pdf) {
        return fail(pdf.error());
    }
    const Status written =
        write_file(request.report, {pdf->constData(), static_cast<std::size_t>(pdf->size())}, job);
    return written ? 0 : fail(written.error());
}

}  // namespace vybeg::cli
