#pragma once

#include <QToolButton>
#include <QWidget>

namespace vybeg::ui {

// A titled part of a panel that can be folded away. The title is a button: Tab reaches it, Space
// folds.
class Section : public QWidget {
    Q_OBJECT

public:
    explicit Section(QWidget* content, QWidget* parent = nullptr);

    void setTitle(const QString& title);
    void setOpen(bool open);
    bool isOpen() const { return title_->isChecked(); }

signals:
    // By a person.
    void clicked();

private:
    QToolButton* title_;
    QWidget* content_;
};

}  // namespace vybeg::ui
