#pragma once

#include "ui/document/document.h"

#include <QWidget>

class QComboBox;
class QLabel;
class QPushButton;
class QToolButton;

namespace vybeg::ui {

class FileList;

// Recordings of a set and options of their identification.
class SetPanel : public QWidget {
    Q_OBJECT

public:
    explicit SetPanel(Document& document, QWidget* parent = nullptr);

private:
    void refresh();
    void refreshMembers(const RecordingSet* set);
    void removeLogs(const RecordingSet& set, const QStringList& paths);
    void retranslate();

    Document& document_;
    QComboBox* sets_;
    QToolButton* add_;
    QToolButton* remove_;
    FileList* members_;  // the open recordings, those of the set checked; Delete unchecks
    QLabel* listed_;     // where the settings are from
    QPushButton* logs_;  // asks what the logs of the set are
    QLabel* model_label_;
    QComboBox* model_;
    QPushButton* identify_;
};

// Name of a set: the given one, that of its only recording, or "Set 2".
QString setName(const Document& document, const RecordingSet& set);

}  // namespace vybeg::ui
