#pragma once

#include "ui/window/page_stack.h"

#include <QList>
#include <QSize>

#include <optional>
#include <set>
#include <utility>
#include <vector>

class QAction;
class QDockWidget;
class QMainWindow;

namespace vybeg::ui {

// The panels beside the pages. A page shows only those that act on it, the others give it their
// room; panels that the user has closed stay closed.
class PagePanels {
public:
    explicit PagePanels(QMainWindow& window) : window_(window) {}

    // `title`: a text of context "vybeg::ui::MainWindow"; `pages`: those that it acts on.
    QDockWidget* add(QWidget* panel, const char* name, const char* title, Qt::DockWidgetArea area,
                     const std::set<Page>& pages);
    void showThoseOf(std::optional<Page> page);  // nothing: none of them
    // As the user has arranged them, on whatever page.
    void showAll();
    // They show and hide the panels.
    QList<QAction*> actions() const;
    void retranslate();

private:
    struct Panel {
        QDockWidget* dock;
        const char* title;
        std::set<Page> pages;
    };

    QMainWindow& window_;
    std::vector<Panel> panels_;
    // Hidden on the present page, with the sizes that they come back with.
    std::vector<std::pair<QDockWidget*, QSize>> without_use_;
};

}  // namespace vybeg::ui
