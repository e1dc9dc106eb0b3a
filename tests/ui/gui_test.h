#pragma once

#include "ui/widgets/number_field.h"
#include "ui/window/main_window.h"

#include <QCoreApplication>
#include <QDir>
#include <QSettings>
#include <QStandardPaths>
#include <QTemporaryDir>

#include <memory>

namespace vybeg::ui {

// A place of its own for the settings and files of a test program: nothing of the user's is read or
// changed.
class GuiTestHome {
public:
    GuiTestHome();

    QString path(const QString& name) const { return folder_.filePath(name); }
    // A decay of a_A = 1, a_B = 0.1, 2theta_A = 0.4 at 1000 Hz, sampled at 8000 Hz, with noise
    // of standard deviation 1e-3; WAV or CSV by the ending.
    QString recording(const QString& name, double seconds = 2) const;
    QString file(const QString& name, const QByteArray& content) const;

private:
    QTemporaryDir folder_;
};

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

// All plots of the page of the tracks, in the size they propose, as the window writes them.
bool exportPlotsTo(MainWindow& window, const QString& path);

}  // namespace vybeg::ui
