#pragma once

#include "ui/document/document.h"

#include <QWidget>

#include <functional>
#include <vector>

class QLabel;
class QPushButton;
class QToolButton;
class QVBoxLayout;

namespace vybeg::ui {

// Messages over the status line, but for news; none blocks. Of the newest one line is shown: the
// rest of its text, and the others below it, show over the window at a click. Of more than three
// some are counted in a line, and come as others are closed.
class MessageBar : public QWidget {
    Q_OBJECT

public:
    explicit MessageBar(QWidget* parent = nullptr);

    // At the lower end of the window, which keeps so many pixels at the right free of messages.
    void floatOver(QWidget& window, std::function<int()> kept_free);
    // Takes its place again.
    void settle();
    // Of one line.
    int lineHeight() const;
    void add(const Message& message);
    void clear();
    // Removes the message of a topic.
    void withdraw(Topic topic);
    // Newest first, also those that wait.
    QStringList texts() const;

signals:
    // Has messages now, or no more.
    void cameOrWent();

private:
    struct Row {
        Message message;
        QWidget* widget = nullptr;
        QLabel* text = nullptr;
        QToolButton* close = nullptr;
        std::vector<QPushButton*> buttons;
    };
    void retranslate();
    void nameRow(const Row& row);
    void remove(QWidget* widget);
    void showRows();
    // The newest, with its whole text in a line so wide.
    bool fits(int width) const;

    QVBoxLayout* layout_;
    std::vector<Row> rows_;
    bool opened_ = false;  // by the button
    QToolButton* open_;
    QWidget* more_;
    QLabel* waiting_;
    QToolButton* close_all_;
    std::function<int()> kept_free_;
};

}  // namespace vybeg::ui
