#pragma once

#include <QMenu>

namespace vybeg::ui {

// The "Open recent" menu: the last recordings that could be opened, newest first, kept between
// sessions.
class RecentFiles : public QMenu {
    Q_OBJECT

public:
    explicit RecentFiles(QWidget* parent = nullptr);

    void add(const QString& path);
    QStringList paths() const;

signals:
    void chosen(const QString& path);

private:
    void rebuild();
};

}  // namespace vybeg::ui
