#include "ui/window/recent_files.h"

#include "ui/widgets/page_parts.h"
#include "ui/words/rich_text.h"

#include <QDir>
#include <QFileInfo>
#include <QSettings>

namespace vybeg::ui {

namespace {

constexpr int most_files = 10;
const QString key = QStringLiteral("recent_files");

}  // namespace

RecentFiles::RecentFiles(QWidget* parent) : QMenu(parent) {
    setToolTipsVisible(true);
    connect(this, &QMenu::aboutToShow, this, &RecentFiles::rebuild);
    keepTranslated(*this, [this] { rebuild(); });
}

QStringList RecentFiles::paths() const {
    return QSettings().value(key).toStringList();
}

void RecentFiles::add(const QString& path) {
    const QString absolute = QFileInfo(path).absoluteFilePath();
    QStringList files = paths();
    files.removeAll(absolute);
    files.prepend(absolute);
    while (files.size() > most_files) {
        files.removeLast();
    }
    QSettings().setValue(key, files);
    rebuild();
}

void RecentFiles::rebuild() {
    clear();
    const QStringList files = paths();
    setEnabled(!files.isEmpty());
    for (qsizetype i = 0; i < files.size(); ++i) {
        const QString& path = files[i];
        QString name = QFileInfo(path).fileName();
        name.replace(QLatin1Char('&'), QStringLiteral("&&"));
        QAction* action = addAction(i < 9 ? QStringLiteral("&%1 %2").arg(i + 1).arg(name) : name);
        action->setToolTip(plainTip(QDir::toNativeSeparators(path)));
        connect(action, &QAction::triggered, this, [this, path] { emit chosen(path); });
    }
    if (!files.isEmpty()) {
        addSeparator();
        connect(addAction(tr("Clear this list")), &QAction::triggered, this, [this] {
            QSettings().remove(key);
            // Queued: the action that was triggered belongs to the menu being rebuilt.
            QMetaObject::invokeMethod(this, &RecentFiles::rebuild, Qt::QueuedConnection);
        });
    }
}

}  // namespace vybeg::ui
