#pragma once

#include <QListWidget>

#include <functional>
#include <utility>

namespace vybeg::ui {

// The files that are dragged from elsewhere.
QStringList localFiles(const QMimeData& data);

// Lets files be dropped onto a view.
void takeFiles(QAbstractScrollArea& view, std::function<void(const QStringList&)> dropped);
// A hint in a part of a view that is empty.
void drawHint(const QAbstractScrollArea& view, const QRect& room, const QString& hint);

// Files of one kind, which can be dropped there and chosen ones removed with Delete: three lines
// high, or as many as there are files, up to `most_rows`. An item has its path as Qt::UserRole.
class FileList : public QListWidget {
    Q_OBJECT

public:
    explicit FileList(int most_rows, QWidget* parent = nullptr);

    QSize sizeHint() const override;
    QStringList chosenPaths() const;
    void removeChosen();

    // The text shown while it is empty, in the language of the window.
    void setHint(std::function<QString()> hint) { hint_ = std::move(hint); }

signals:
    void dropped(const QStringList& files);
    void removalWanted(const QStringList& chosen);

protected:
    void keyPressEvent(QKeyEvent* event) override;
    void paintEvent(QPaintEvent* event) override;

private:
    int most_rows_;
    std::function<QString()> hint_;
};

}  // namespace vybeg::ui
