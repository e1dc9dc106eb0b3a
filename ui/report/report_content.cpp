#include "ui/report/report_content.h"

#include "ui/words/error_text.h"

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

}  // namespace vybeg::ui
