#include "ui/window/window_title.h"

#include <QFileInfo>
#include <QStringList>

namespace vybeg::ui {

QString titleOf(const Document& document, const QString& session) {
    const RecordingEntry* entry = document.currentRecording();
    QStringList parts;
    if (!session.isEmpty()) {
        parts << QFileInfo(session).fileName();
    }
    if (const QString& serial = document.dossier().dossier().gyro.serial; !serial.isEmpty()) {
        parts << serial;
    }
    if (entry && (entry->recording || entry->envelope)) {
        parts << entry->name;
    }
    parts << QStringLiteral("Vybeg");
    return parts.join(QStringLiteral(" — "));
}

}  // namespace vybeg::ui
