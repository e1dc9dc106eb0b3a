#pragma once

#include <QListWidget>

namespace vybeg::ui {

// Files of one kind, which can be dropped there: three lines high, or as many as there are files,
// up to `most_rows`.
class FileList : public QListWidget {
    Q_OBJECT

public:
    explicit FileList(int most_rows, QWidget* parent = nullptr);

    QSize sizeHint() const override;

protected:
    // Takes what was dropped.
    virtual void take(const QStringList& files) = 0;
    // What stands there while it is empty.
    virtual QString hint() const = 0;

    void dragEnterEvent(QDragEnterEvent* event) override;
    void dragMoveEvent(QDragMoveEvent* event) override;
    void dropEvent(QDropEvent* event) override;
    void paintEvent(QPaintEvent* event) override;

private:
    int most_rows_;
};

}  // namespace vybeg::ui
