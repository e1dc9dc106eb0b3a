#include "ui/panels/recording_drag.h"

#include <QCoreApplication>
#include <QIODevice>
#include <QMimeData>
#include <QUrl>

#include <algorithm>

namespace vybeg::ui {

namespace {

// Ids are valid in this process only; with the process number in the type, other windows reject
// them.
QString recordingType() {
    return QStringLiteral("application/x-vybeg-recordings-%1")
        .arg(QCoreApplication::applicationPid());
}

}  // namespace

RecordingId recordingOf(const QListWidgetItem& item) {
    return static_cast<RecordingId>(item.data(Qt::UserRole).toInt());
}

std::vector<RecordingId> recordingsOf(const QList<QListWidgetItem*>& items) {
    std::vector<RecordingId> ids;
    ids.reserve(static_cast<std::size_t>(items.size()));
    for (const QListWidgetItem* item : items) {
        ids.push_back(recordingOf(*item));
    }
    return ids;
}

QMimeData* recordingMimeData(const std::vector<RecordingId>& recording_ids) {
    QByteArray bytes;
    QDataStream stream(&bytes, QIODevice::WriteOnly);
    stream << QList<RecordingId>(recording_ids.begin(), recording_ids.end());
    auto* data = new QMimeData;
    data->setData(recordingType(), bytes);
    return data;
}

std::vector<RecordingId> draggedRecordings(const QMimeData& data) {
    QDataStream stream(data.data(recordingType()));
    QList<RecordingId> ids;
    stream >> ids;
    return {ids.begin(), ids.end()};
}

QStringList localFiles(const QMimeData& data) {
    QStringList files;
    for (const QUrl& url : data.urls()) {
        if (url.isLocalFile()) {
            files << url.toLocalFile();
        }
    }
    return files;
}

}  // namespace vybeg::ui
