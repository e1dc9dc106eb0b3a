#include "ui/report/report_content.h"

#include "core/analysis/setting_table.h"
#include "core/batch/identify_set.h"
#include "ui/resonator/set_panel.h"
#include "ui/words/error_text.h"

#include <QRegularExpression>

#include <algorithm>
#include <initializer_list>
#include <iterator>
#include <string_view>

namespace vybeg::ui {

namespace {

// A condition of the recordings, each value once; otherwise `usual`.
QString told(const MeasurementSet& set, std::string Conditions::*condition, const QString& usual) {
    QStringList values;
    for (const RecordingRef& listed : set.recordings) {
        const QString value = dateText(QString::fromStdString(listed.conditions.*condition));
        if (!value.isEmpty() && !values.contains(value)) {
            values << value;
        }
    }
    return values.isEmpty() ? usual : values.join(QStringLiteral("; "));
}

// `listed`: as settings_list().
template <class S>
QString rowsText(const std::vector<SettingRow<S>>& rows, const std::vector<NamedValue>& listed,
                 std::initializer_list<std::string_view> left_out = {}) {
    const S defaults;
    QStringList options;
    for (const SettingRow<S>& row : rows) {
        const auto value = std::ranges::find(listed, row.name, &NamedValue::first);
        if (value == listed.end()) {
            continue;
        }
        const std::string& text = value->second;
        if (text == row.text(defaults) || std::ranges::find(left_out, row.name) != left_out.end()) {
            continue;
        }
        const QString option = QString::fromStdString(row.option());
        const bool is_switch = row.placeholder.empty() && text.find(';') == std::string::npos;
        options << (is_switch ? option : option + QLatin1Char(' ') + QString::fromStdString(text));
    }
    return options.join(QLatin1Char(' '));
}

bool isReported(const AnalysisEntry& entry) {
    return entry.shown.visible && !entry.partial();
}

// Ids of the recordings that are open and have an analysis.
std::vector<RecordingId> analysed(const Document& document, const std::vector<RecordingId>& ids) {
    std::vector<RecordingId> found;
    std::ranges::copy_if(ids, std::back_inserter(found), [&](RecordingId id) {
        const RecordingEntry* recording = document.recording(id);
        return recording && recording->recording &&
               std::ranges::any_of(document.analyses(), [id](const AnalysisEntry& entry) {
                   return entry.recording_id == id && isReported(entry);
               });
    });
    return found;
}

// Logs have no analyses of their own.
bool isReportedLog(const Document& document, const RecordingSet& set) {
    return isOfLogs(set) && document.sets().outcome(set);
}

// The set whose identification a report shows.
const RecordingSet* identifiedSet(const Document& document, const ReportSubject& subject) {
    if (subject.set != SetId::none) {
        return document.sets().find(subject.set);
    }
    if (subject.recordings.empty()) {
        return nullptr;
    }
    const auto& sets = document.sets().all();
    const auto alone = std::ranges::find_if(sets, [&](const RecordingSet& set) {
        return set.recordings == subject.recordings && document.sets().outcome(set);
    });
    return alone == sets.end() ? nullptr : &*alone;
}

}  // namespace

ReportTitle titleOf(const MeasurementSet& set, const ReportTitle& usual) {
    ReportTitle title = usual;
    for (const TitleField& field : title_fields) {
        if (field.told) {
            title.*field.text = told(set, field.told, usual.*field.text);
        }
    }
    return title;
}

ReportTitle titleOf(const GyroData& gyro) {
    ReportTitle title;
    title.gyro = gyro.serial;
    title.engineer = gyro.operator_name;
    title.comment = gyro.comment.simplified();
    return title;
}

ReportTitle completed(const ReportTitle& title, const ReportTitle& otherwise) {
    ReportTitle whole = title;
    for (const TitleField& field : title_fields) {
        if ((whole.*field.text).isEmpty()) {
            whole.*field.text = otherwise.*field.text;
        }
    }
    return whole;
}

bool ofLogsAlone(const ReportContent& content) {
    return content.recordings.empty() && content.drift;
}

bool hasAnalyses(const ReportContent& content) {
    return std::ranges::any_of(content.recordings, [](const ReportRecording& recording) {
        return !recording.analyses.empty();
    });
}

QString dateText(const QString& standard) {
    static const QRegularExpression date(QStringLiteral("^(\\d{4}-\\d\\d-\\d\\d)T(\\d\\d:\\d\\d)"));
    return QString(standard).replace(date, QStringLiteral("\\1 \\2"));
}

QString firstAndLast(const QStringList& texts) {
    return texts.size() > 1 ? QStringLiteral("%1 … %2").arg(texts.first(), texts.last())
                            : texts.value(0);
}

QString measuredOn(const std::vector<ReportRecording>& recordings) {
    QStringList starts;
    for (const ReportRecording& each : recordings) {
        if (const QString start = dateText(QString::fromStdString(each.file.start));
            !start.isEmpty() && !starts.contains(start)) {
            starts << start;
        }
    }
    return firstAndLast(starts);
}

QString optionsText(const Settings& settings) {
    return rowsText(analysis_settings(), settings_list(settings),
                    {"algorithm", "window", "hop", "f0"});
}

QString optionsText(const DriftSettings& settings) {
    return rowsText(drift_settings(), listed(drift_settings(), settings));
}

QString optionsText(const IdentifySettings& settings) {
    return rowsText(identify_settings(), settings_list(settings));
}

std::vector<ReportSubject> reportSubjects(const Document& document) {
    std::vector<ReportSubject> subjects;
    const auto add_set = [&](const RecordingSet& set) {
        const std::vector<RecordingId> recordings = analysed(document, set.recordings);
        if (!recordings.empty() || isReportedLog(document, set)) {
            subjects.push_back({setName(document, set), recordings, set.id, false});
        }
    };
    const RecordingEntry* recording = document.currentRecording();
    const RecordingSet* current = document.sets().current();
    const bool holds_it =
        current && (isOfLogs(*current) ||
                    (recording && std::ranges::find(current->recordings, recording->id) !=
                                      current->recordings.end()));
    if (holds_it) {
        add_set(*current);
    }
    if (recording && !analysed(document, {recording->id}).empty()) {
        subjects.push_back({recording->name, {recording->id}, SetId::none, false});
    }
    for (const RecordingSet& set : document.sets().all()) {
        if (!holds_it || set.id != current->id) {
            add_set(set);
        }
    }
    std::vector<ReportSubject> sets;
    std::ranges::copy_if(subjects, std::back_inserter(sets),
                         [](const ReportSubject& each) { return each.set != SetId::none; });
    if (sets.size() > 1) {
        ReportSubject all{ReportWords::tr("All sets"), {}, SetId::none, true};
        for (const ReportSubject& each : sets) {
            all.recordings.insert(all.recordings.end(), each.recordings.begin(),
                                  each.recordings.end());
        }
        subjects.push_back(all);
    }
    if (document.drift().outcome()) {
        subjects.push_back({ReportWords::tr("Whole-angle logs alone"), {}, SetId::none, false});
    }
    return subjects;
}

std::vector<ReportContent> reportContentsOf(const Document& document, const ReportSubject& subject,
                                            const ReportTitle& usual) {
    if (!subject.all_sets) {
        return {reportContentOf(document, subject, usual)};
    }
    std::vector<ReportContent> contents;
    for (const RecordingSet& set : document.sets().all()) {
        const std::vector<RecordingId> recordings = analysed(document, set.recordings);
        if (!recordings.empty() || isReportedLog(document, set)) {
            const QString name = setName(document, set);
            contents.push_back(reportContentOf(document, {name, recordings, set.id, false}, usual));
            contents.back().set = name;
            contents.back().drift.reset();  // sets may be those of several gyros
            contents.back().chapter = static_cast<int>(contents.size());
        }
    }
    return contents;
}

ReportContent reportContentOf(const Document& document, const ReportSubject& subject,
                              const ReportTitle& usual) {
    ReportContent content;
    content.title = usual;
    const RecordingSet* set = identifiedSet(document, subject);
    for (const RecordingId id : subject.recordings) {
        const RecordingEntry& entry = *document.recording(id);
        const auto row = set ? rowOf(*set, id) : std::nullopt;
        ReportRecording told{row ? set->listed->recordings[*row]
                                 : RecordingRef{entry.name.toStdString(), entry.recording->path},
                             formatText(entry.recording->format)};
        set_extent(told.file, *entry.recording);
        told.file.sha256 = entry.sha256.toStdString();
        if (entry.faults) {
            told.check = entry.faults->findings;
        }
        std::ranges::copy_if(document.analyses(), std::back_inserter(told.analyses),
                             [id](const AnalysisEntry& analysis) {
                                 return analysis.recording_id == id && isReported(analysis);
                             });
        content.recordings.push_back(std::move(told));
    }
    if (set && isReportedLog(document, *set)) {
        for (const RecordingRef& log : document.sets().outcome(*set)->set.recordings) {
            content.recordings.push_back({log});
        }
    }
    content.limits = document.dossier().dossier().limits;
    content.drift = document.drift().outcome();
    if (set) {
        content.title = titleOf(document.sets().measured(*set), usual);
        content.absent = absentFiles(*set);
        content.outcome = document.sets().outcome(*set);
        if (const Error* const refusal = document.sets().refusal(*set);
            refusal && !content.outcome) {
            content.not_identified = *refusal;
        }
        content.out_of_date = content.outcome && document.sets().outOfDate(*set, *content.outcome);
    }
    if (content.title.date.isEmpty()) {
        content.title.date = measuredOn(content.recordings);
    }
    return content;
}

}  // namespace vybeg::ui
