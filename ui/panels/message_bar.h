#pragma once

#include "ui/document/document.h"

#include <QWidget>

#include <vector>

class QLabel;
class QPushButton;
class QToolButton;
class QVBoxLayout;

namespace vybeg::ui {

// Messages in the window, above the plots: nothing has to be answered, nothing blocks. The newest
// stands on top; more than three push the oldest out.
class MessageBar : public QWidget {
    Q_OBJECT

public:
    explicit MessageBar(QWidget* parent = nullptr);

    void add(const Message& message);
    void clear();
    // Takes what was told about a topic away.
    void withdraw(Topic topic);
    // Texts on display, newest first.
    QStringList texts() const;

signals:
    // The engineer wants to open a file again and say how.
    void reopenWanted(const QString& path, const OpenOptions& options);

protected:
    void changeEvent(QEvent* event) override;

private:
    struct Row {
        Message message;
        QWidget* widget = nullptr;
        QLabel* text = nullptr;
        QToolButton* close = nullptr;
        QPushButton* action = nullptr;
    };
    void retranslate();
    void remove(QWidget* widget);

    QVBoxLayout* layout_;
    std::vector<Row> rows_;
};

}  // namespace vybeg::ui
