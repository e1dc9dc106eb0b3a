#include "ui/panels/file_list.h"

#include <QDropEvent>
#include <QKeyEvent>
#include <QMimeData>
#include <QPainter>
#include <QUrl>

#include <algorithm>

namespace vybeg::ui {

QStringList localFiles(const QMimeData& data) {
    QStringList files;
    for (const QUrl& url : data.urls()) {
        if (url.isLocalFile()) {
            files << url.toLocalFile();
        }
    }
    return files;
}

namespace {

class FileDrop : public QObject {
public:
    FileDrop(QAbstractScrollArea& view, std::function<void(const QStringList&)> dropped)
        : QObject(&view), dropped_(std::move(dropped)) {
        view.setAcceptDrops(true);
        view.viewport()->installEventFilter(this);
    }

    bool eventFilter(QObject* watched, QEvent* event) override {
        const auto type = event->type();
        if (type != QEvent::DragEnter && type != QEvent::DragMove && type != QEvent::Drop) {
            return QObject::eventFilter(watched, event);
        }
        auto* drag = static_cast<QDropEvent*>(event);
        const QStringList files = localFiles(*drag->mimeData());
        drag->setDropAction(Qt::CopyAction);
        drag->setAccepted(!files.isEmpty());
        if (type == QEvent::Drop && !files.isEmpty()) {
            dropped_(files);
        }
        return true;
    }

private:
    std::function<void(const QStringList&)> dropped_;
};

}  // namespace

void takeFiles(QAbstractScrollArea& view, std::function<void(const QStringList&)> dropped) {
    new FileDrop(view, std::move(dropped));
}

void drawHint(const QAbstractScrollArea& view, const QRect& room, const QString& hint) {
    QPainter painter(view.viewport());
    painter.setPen(view.palette().color(QPalette::PlaceholderText));
    painter.drawText(room.adjusted(8, 2, -8, -2), Qt::AlignCenter | Qt::TextWordWrap, hint);
}

FileList::FileList(int most_rows, QWidget* parent) : QListWidget(parent), most_rows_(most_rows) {
    takeFiles(*this, [this](const QStringList& files) { emit dropped(files); });
    setTextElideMode(Qt::ElideMiddle);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);  // beside which no name is shortened
    setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
}

QSize FileList::sizeHint() const {
    const int rows = std::clamp(count(), 3, most_rows_);
    return {200, rows * (fontMetrics().height() + 4) + 2 * frameWidth()};
}

QStringList FileList::chosenPaths() const {
    QStringList paths;
    for (const QListWidgetItem* item : selectedItems()) {
        paths << item->data(Qt::UserRole).toString();
    }
    return paths;
}

// The focus does not fall to a field, whose undo would hide that of the files.
void FileList::removeChosen() {
    setFocus();
    emit removalWanted(chosenPaths());
}

void FileList::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_Delete) {
        removeChosen();
    } else {
        QListWidget::keyPressEvent(event);
    }
}

void FileList::paintEvent(QPaintEvent* event) {
    QListWidget::paintEvent(event);
    if (count() == 0) {
        drawHint(*this, viewport()->rect(), hint_());
    }
}

}  // namespace vybeg::ui

#include "moc_file_list.cpp"
