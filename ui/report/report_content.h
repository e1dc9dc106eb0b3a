#pragma once

#include "core/analysis/identify_settings.h"
#include "core/analysis/measurement_list.h"
#include "core/analysis/settings.h"
#include "core/base/error.h"
#include "core/drift/drift_settings.h"
#include "core/recording/samples/recording.h"
#include "core/resonator/results/resonator_parameters.h"
#include "ui/document/analysis_store.h"
#include "ui/document/document.h"
#include "ui/document/drift_store.h"
#include "ui/document/edits.h"
#include "ui/values/ids.h"
#include "ui/values/recording_set.h"
#include "ui/words/display_units.h"

#include <QCoreApplication>
#include <QString>
#include <QStringList>

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace vybeg::ui {

// Texts of context "Report" in the interface's language.
struct ReportWords {
    Q_DECLARE_TR_FUNCTIONS(Report)
};

// Data of a report that no file has. An empty text leaves a line to be filled in by hand.
struct ReportTitle {
    QString number;  // of the report
    QString gyro;    // serial number
    QString instrument;
    QString engineer;
    QString date;  // of the recordings
    QString comment;
};

struct TitleField {
    const char* option;  // of the command line, without its dashes
    const char* name;    // ReportWords::tr()
    const char* help;    // of the option
    QString ReportTitle::*text;
    std::string Conditions::*told;  // in a measurement list; nullptr: not there
};

// In the order of a report.
inline constexpr std::array<TitleField, 6> title_fields{{
    {"number", QT_TRANSLATE_NOOP("Report", "Report number"), "number of the report",
     &ReportTitle::number, nullptr},
    {"gyro", QT_TRANSLATE_NOOP("Report", "Gyro, serial number"), "serial number of the gyro",
     &ReportTitle::gyro, &Conditions::gyro},
    {"instrument", QT_TRANSLATE_NOOP("Report", "Instrument"),
     "recorder and electronics that measured", &ReportTitle::instrument, nullptr},
    {"operator", QT_TRANSLATE_NOOP("Report", "Operator"), "who measured", &ReportTitle::engineer,
     &Conditions::operator_name},
    {"date", QT_TRANSLATE_NOOP("Report", "Date of measurement"), "date of the measurement",
     &ReportTitle::date, &Conditions::date},
    {"comment", QT_TRANSLATE_NOOP("Report", "Comment"), "a comment for the title",
     &ReportTitle::comment, &Conditions::comment},
}};

// A recording, or a log, as it was read, with what the report shows of it.
struct ReportRecording {
    RecordingRef file;                               // without a hash: not computed yet
    QString format{};                                // formatText(); empty: a log
    std::optional<std::vector<Diagnostic>> check{};  // findings; none: not finished yet
    std::vector<AnalysisEntry> analyses{};

    QString name() const { return QString::fromStdString(file.name()); }
};

// The title by the measurement list of a set; where recordings differ, all of it. `usual` where the
// list has no text.
ReportTitle titleOf(const MeasurementSet& set, const ReportTitle& usual);

// The title that a gyro's data give, without a date.
ReportTitle titleOf(const GyroData& gyro);

// The title, with the texts of `otherwise` where it has none.
ReportTitle completed(const ReportTitle& title, const ReportTitle& otherwise);

// A date with a time by ISO 8601 (2026-11-28T09:59) for people, "2026-11-28 09:59"; any other text
// as it is.
QString dateText(const QString& standard);

// "first … last" of several; empty of none.
QString firstAndLast(const QStringList& texts);

// Date of the recordings in their files; the first and the last of several. Empty where
// none does.
QString measuredOn(const std::vector<ReportRecording>& recordings);

// Everything that a report shows, as a value. Its texts are in the language in which it is laid
// out.
struct ReportContent {
    QString set;      // its name in a report of several sets
    int chapter = 0;  // its number there, from 1; 0: the only one
    ReportTitle title;
    std::vector<ReportRecording> recordings;
    std::shared_ptr<const SetResult> outcome;
    QStringList absent;        // recordings of the set's list that are not in it
    bool out_of_date = false;  // the outcome is of other settings than the present ones
    std::optional<Error>
        not_identified;  // reason for the absence of the outcome, where one is known
    std::vector<ParameterLimit> limits;
    std::shared_ptr<const DriftOutcome> drift;  // of whole-angle logs; null: none
    bool summary = false;                       // the page to be signed alone
    DisplayUnits units;
    std::vector<SlowVariable> variables{main_slow_variables.begin(), main_slow_variables.end()};
};

// Whether a report is about whole-angle logs without any recording.
bool ofLogsAlone(const ReportContent& content);

bool hasAnalyses(const ReportContent& content);

// The settings that have a part in the result and are not the defaults, as options of the command
// line; empty: all are.

// Without algorithm, window, hop and carrier, which the table of analyses has.
QString optionsText(const Settings& settings);

// Settings in which the recordings differ have the value of each, with semicolons between them.
QString optionsText(const IdentifySettings& settings);

QString optionsText(const DriftSettings& settings);

// What a report can be about: a set of recordings, one recording, all sets, or the whole-angle
// logs, which every report but that of all sets holds.
struct ReportSubject {
    QString name;
    std::vector<RecordingId> recordings;  // those that are open
    SetId set = SetId::none;              // none: one recording, all sets, or logs
    bool all_sets = false;

    friend bool operator==(const ReportSubject&, const ReportSubject&) = default;
};

// The current set first where it has the current recording, then the current recording, then the
// other sets, all sets where there are several, and logs with a drift. Of recordings only those
// with an analysis that has all its windows.
std::vector<ReportSubject> reportSubjects(const Document& document);

// What the document holds of a subject: visible analyses, and the newest identification of the set
// or of the recording alone. The title is that of the set's list, where that has no text `usual`,
// and without a date there that of the files. All sets are a chapter each.
std::vector<ReportContent> reportContentsOf(const Document& document, const ReportSubject& subject,
                                            const ReportTitle& usual = {});

// The same of one set or recording.
ReportContent reportContentOf(const Document& document, const ReportSubject& subject,
                              const ReportTitle& usual = {});

}  // namespace vybeg::ui
