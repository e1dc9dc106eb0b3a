#pragma once

#include "ui/document/document.h"
#include "ui/values/ids.h"

#include <QListWidget>

#include <vector>

class QMimeData;

namespace vybeg::ui {

// The recording of an item, whose Qt::UserRole is the number of the id.
RecordingId recordingOf(const QListWidgetItem& item);
std::vector<RecordingId> recordingsOf(const QList<QListWidgetItem*>& items);

// Data of a drag: recordings of this window, or files.
QMimeData* recordingMimeData(const std::vector<RecordingId>& recording_ids);
std::vector<RecordingId> draggedRecordings(const QMimeData& data);
QStringList localFiles(const QMimeData& data);

}  // namespace vybeg::ui
