#pragma once

#include "ui/document/recording_store.h"

#include <QString>
#include <QStringList>

class QMimeData;

namespace vybeg::ui {

// What is known of a recording, a line each: file, format, rate, length, channels, start, carrier,
// SHA-256.
QString recordingFacts(const RecordingEntry& entry);

// Whether its check or its reading found something worse than a note.
bool hasFindings(const RecordingEntry& entry);

// The files of what is dragged from elsewhere.
QStringList localFiles(const QMimeData& data);

}  // namespace vybeg::ui
