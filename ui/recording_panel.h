#pragma once

#include "ui/document.h"

#include <QWidget>

#include <vector>

class QAction;
class QFormLayout;
class QLabel;
class QListWidget;

namespace vybeg::ui {

class CheckList;

// The open recordings, and what is known of the current one.
class RecordingPanel : public QWidget {
    Q_OBJECT

public:
    explicit RecordingPanel(Document& document, QWidget* parent = nullptr);

    QSize sizeHint() const override { return {310, 340}; }

signals:
    // The engineer wants to open the current recording in another way (rate, channels).
    void placeChosen(double time_s, double seconds);
    void reopenWanted(const QString& path, const OpenOptions& options);

protected:
    void changeEvent(QEvent* event) override;

private:
    enum Row { file, format, rate, length, channels, start, carrier, sha256, row_count };

    void rebuildList();
    void refreshInfo();
    void retranslate();

    Document& document_;
    QListWidget* list_;
    QAction* close_;
    QAction* reopen_;
    QFormLayout* info_;
    CheckList* check_;
    std::vector<QLabel*> names_;
    std::vector<QLabel*> values_;
};

}  // namespace vybeg::ui
