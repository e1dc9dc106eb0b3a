#pragma once

#include "tests/ui/gui_home.h"
#include "ui/widgets/number_field.h"
#include "ui/window/main_window.h"

#include <QString>

#include <memory>
#include <vector>

class QTableWidgetItem;

namespace vybeg::ui {

// The widget of a kind, and of a name if there are several, in a window: it must be there.
template <class Widget>
Widget& childOf(const QObject& window, const QString& name = {}) {
    auto* widget = window.findChild<Widget*>(name);
    if (!widget) {
        qFatal("no such widget in the window: %s %s", Widget::staticMetaObject.className(),
               qUtf8Printable(name));
    }
    return *widget;
}

// Chooses the tabs in which a widget lies.
void bringUp(QWidget& widget);

// The field of a window by its accessible name: it must be there.
NumberField& fieldOf(const QWidget& window, const QString& accessible_name);

// Takes the place of the field's text, as a person types it, up to Return.
void typeInto(NumberField& field, const char* text);

// The main window in English, 1400 x 900, on the screen, with no settings of an earlier one but
// that it is not live: a run is what a test asks for.
struct OwnDocument {
    Document own_document;
};

// A window with a document of its own, which outlives it.
class TestWindow : private OwnDocument, public MainWindow {
public:
    TestWindow() : MainWindow(own_document) {}
};

std::unique_ptr<MainWindow> shownWindow();

// What the tests of the window share: a folder of its settings and files, and the window.
class WindowTest {
protected:
    Document& document() { return window_->document(); }
    template <class Widget>
    Widget& the(const QString& name = {}) {
        return childOf<Widget>(*window_, name);
    }
    NumberField& field(const QString& accessible_name) {
        return fieldOf(*window_, accessible_name);
    }
    // Waits until the document rests with so many analyses; whether it does.
    bool idle(std::size_t analyses);
    // Of the recordings of the document: their ids, and whether all are open.
    std::vector<RecordingId> ids();
    bool allOpen();
    // Opens files and waits until their analyses have ended.
    void openRuns(const QStringList& files);
    // A cell of a QuantityTable, in a row by the beginning of its name; null without the row.
    QTableWidgetItem* cellOf(const QString& table, const QString& name, int column);
    // The same in the column of that header; null: it has none.
    QTableWidgetItem* cellOf(const QString& table, const QString& name, const QString& header);

    GuiTestHome home_;
    std::unique_ptr<MainWindow> window_;
};

// Drags files onto a widget and drops them there; whether it takes them.
bool dropFiles(QWidget& target, const QStringList& paths);

// Whether the window's session is in a file, as a person sees it after saving.
bool savedTo(MainWindow& window, const QString& path);

// All plots of the page of the tracks, in the size they propose, as the window writes them.
bool exportPlotsTo(MainWindow& window, const QString& path);

}  // namespace vybeg::ui
