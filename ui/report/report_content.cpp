#include "ui/report/report_content.h"

#include "ui/words/error_text.h"

#include <QStringList>

namespace vybeg::ui {

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
