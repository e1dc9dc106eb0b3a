#include "ui/window/page_panels.h"

#include <QAbstractButton>
#include <QCoreApplication>
#include <QDockWidget>
#include <QMainWindow>

namespace vybeg::ui {

QDockWidget* PagePanels::add(QWidget* panel, const char* name, const char* title,
                             Qt::DockWidgetArea area, const std::set<Page>& pages) {
    auto* dock = new QDockWidget(&window_);
    dock->setObjectName(QLatin1String(name));
    dock->setWidget(panel);
    window_.addDockWidget(area, dock);
    panels_.push_back({dock, title, pages});
    return dock;
}

void PagePanels::showAll() {
    QList<QDockWidget*> back;
    QList<int> widths;
    QList<int> heights;
    for (const auto& [dock, size] : std::exchange(without_use_, {})) {
        dock->show();
        back << dock;
        widths << size.width();
        heights << size.height();
    }
    window_.resizeDocks(back, widths, Qt::Horizontal);
    window_.resizeDocks(back, heights, Qt::Vertical);
}

void PagePanels::showThoseOf(std::optional<Page> page) {
    showAll();
    for (const Panel& panel : panels_) {
        if (!(page && panel.pages.contains(*page)) && !panel.dock->isHidden()) {
            without_use_.emplace_back(panel.dock, panel.dock->size());
        }
    }
    for (const auto& [dock, size] : without_use_) {
        dock->hide();
    }
}

QList<QAction*> PagePanels::actions() const {
    QList<QAction*> actions;
    for (const Panel& panel : panels_) {
        actions << panel.dock->toggleViewAction();
    }
    return actions;
}

void PagePanels::retranslate() {
    constexpr const char* context = "vybeg::ui::MainWindow";
    for (const Panel& panel : panels_) {
        panel.dock->setWindowTitle(QCoreApplication::translate(context, panel.title));
        // Qt names these once, in the language of the start.
        const auto name = [&panel](const char* button, const QString& text) {
            if (auto* widget = panel.dock->findChild<QAbstractButton*>(QLatin1String(button))) {
                widget->setToolTip(text);
                widget->setAccessibleName(text);
            }
        };
        name("qt_dockwidget_floatbutton",
             QCoreApplication::translate("vybeg::ui::MainWindow", "Float"));
        name("qt_dockwidget_closebutton",
             QCoreApplication::translate("vybeg::ui::MainWindow", "Close this panel"));
    }
}

}  // namespace vybeg::ui
