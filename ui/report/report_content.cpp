#include "ui/report/report_content.h"

#include "core/analysis/setting_table.h"
#include "ui/words/error_text.h"

#include <algorithm>
#include <initializer_list>
#include <string_view>

namespace vybeg::ui {

namespace {

// A condition of the recordings, each value once; otherwise `usual`.
QString told(const MeasurementSet& set, std::string Conditions::*condition, const QString& usual) {
    QStringList values;
    for (const RecordingRef& listed : set.recordings) {
        const QString value = QString::fromStdString(listed.conditions.*condition);
        if (!value.isEmpty() && !values.contains(value)) {
            values << value;
        }
    }
    return values.isEmpty() ? usual : values.join(QStringLiteral("; "));
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

ReportRecording reportRecording(const Recording& recording, const QString& sha256) {
    ReportRecording told;
    told.name = QString::fromStdString(recording.path.filename().string());
    told.format = formatText(recording.format);
    told.start = QString::fromStdString(recording.start);
    told.sha256 = sha256;
    told.rate_hz = recording.rate_hz;
    told.seconds = recording.seconds();
    return told;
}

ReportRecording reportLog(const RecordingRef& log) {
    ReportRecording told;
    told.name = QString::fromStdString(log.name());
    told.format = QCoreApplication::translate("Report", "Log");
    told.sha256 = QString::fromStdString(log.sha256);
    told.rate_hz = log.rate_hz;
    told.seconds = log.seconds;
    told.is_log = true;
    return told;
}

bool ofLogsAlone(const ReportContent& content) {
    return content.recordings.empty() && content.drift;
}

QString measuredOn(const std::vector<ReportRecording>& recordings) {
    QStringList starts;
    for (const ReportRecording& each : recordings) {
        if (!each.start.isEmpty() && !starts.contains(each.start)) {
            starts << each.start;
        }
    }
    return starts.size() > 1 ? QStringLiteral("%1 … %2").arg(starts.first(), starts.last())
                             : starts.value(0);
}

namespace {

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

}  // namespace

QString optionsText(const Settings& settings) {
    return rowsText(analysis_settings(), settings_list(settings),
                    {"algorithm", "window", "hop", "f0"});
}

QString optionsText(const DriftSettings& settings) {
    std::vector<NamedValue> listed;
    for (const SettingRow<DriftSettings>& row : drift_settings()) {
        listed.emplace_back(row.name, row.text(settings));
    }
    return rowsText(drift_settings(), listed);
}

QString optionsText(const IdentifySettings& settings) {
    return rowsText(identify_settings(), settings_list(settings));
}

}  // namespace vybeg::ui
