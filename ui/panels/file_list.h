#pragma once

#include <QListWidget>

class QMimeData;

namespace vybeg::ui {

// The files of what is dragged from elsewhere.
QStringList localFiles(const QMimeData& data);

// Files of one kind, which can be dropped there and chosen ones removed with Delete: three lines
// high, or as many as there are files, up to `most_rows`. An item has its path as Qt::UserRole.
class FileList : public QListWidget {
    Q_OBJECT

public:
    explicit FileList(int most_rows, QWidget* parent = nullptr);

    QSize sizeHint() const override;
    QStringList chosenPaths() const;
    void removeChosen();

protected:
    // Takes what was dropped.
    virtual void take(const QStringList& files) = 0;
    virtual void remove(const QStringList& /*files*/) {}
    // What stands there while it is empty.
    virtual QString hint() const = 0;

    void dragEnterEvent(QDragEnterEvent* event) override;
    void dragMoveEvent(QDragMoveEvent* event) override;
    void dropEvent(QDropEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void paintEvent(QPaintEvent* event) override;

private:
    int most_rows_;
};

}  // namespace vybeg::ui
