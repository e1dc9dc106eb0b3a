#pragma once

#include "ui/document/document.h"

#include <QWidget>

#include <vector>

class QLabel;
class QPushButton;
class QToolButton;
class QVBoxLayout;

namespace vybeg::ui {

// Messages over the lower end of the window, but for news; none blocks. The newest is on top. Of
// more than three some are counted in a line, and come as others are closed.
class MessageBar : public QWidget {
    Q_OBJECT

public:
    explicit MessageBar(QWidget* parent = nullptr);

    // At its lower end, over the plots, so that none moves under the mouse.
    void floatOver(QWidget& place);
    void add(const Message& message);
    void clear();
    // Removes the message of a topic.
    void withdraw(Topic topic);
    // Displayed texts, newest first, without those that wait.
    QStringList texts() const;

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

    QVBoxLayout* layout_;
    std::vector<Row> rows_;
    QWidget* more_;
    QLabel* waiting_;
    QToolButton* close_all_;
};

}  // namespace vybeg::ui
