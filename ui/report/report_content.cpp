#include "ui/report/report_content.h"

#include "ui/words/format_text.h"

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
    return {told(set, &Conditions::gyro, usual.gyro),
            told(set, &Conditions::operator_name, usual.engineer),
            told(set, &Conditions::date, usual.date),
            told(set, &Conditions::comment, usual.comment)};
}

ReportTitle titleOf(const GyroData& gyro) {
    return {gyro.serial, gyro.operator_name, QString(), gyro.comment.simplified()};
}

ReportTitle completed(const ReportTitle& title, const ReportTitle& otherwise) {
    const auto either = [](const QString& text, const QString& other) {
        return text.isEmpty() ? other : text;
    };
    return {either(title.gyro, otherwise.gyro), either(title.engineer, otherwise.engineer),
            either(title.date, otherwise.date), either(title.comment, otherwise.comment)};
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
