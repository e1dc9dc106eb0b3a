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

FileList::FileList(int most_rows, QWidget* parent) : QListWidget(parent), most_rows_(most_rows) {
    setAcceptDrops(true);
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

void FileList::dragEnterEvent(QDragEnterEvent* event) {
    if (!localFiles(*event->mimeData()).isEmpty()) {
        event->setDropAction(Qt::CopyAction);
        event->accept();
    }
}

void FileList::dragMoveEvent(QDragMoveEvent* event) {
    event->setDropAction(Qt::CopyAction);
    event->accept();
}

void FileList::dropEvent(QDropEvent* event) {
    emit dropped(localFiles(*event->mimeData()));
    event->setDropAction(Qt::CopyAction);
    event->accept();
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
        QPainter painter(viewport());
        painter.setPen(palette().color(QPalette::PlaceholderText));
        painter.drawText(viewport()->rect().adjusted(8, 2, -8, -2),
                         Qt::AlignCenter | Qt::TextWordWrap, hint_());
    }
}

}  // namespace vybeg::ui

#include "moc_file_list.cpp"
