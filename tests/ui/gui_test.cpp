#include "tests/ui/gui_test.h"

#include "ui/session/session_keeper.h"
#include "ui/widgets/quantity_table.h"
#include "ui/window/file_commands.h"
#include "ui/window/tracks_page.h"

#include <QDropEvent>
#include <QMimeData>
#include <QTabWidget>
#include <QTest>

#include <algorithm>
#include <iterator>
#include <numeric>

namespace vybeg::ui {

void bringUp(QWidget& widget) {
    for (QWidget* around = widget.parentWidget(); around; around = around->parentWidget()) {
        auto* tabs = qobject_cast<QTabWidget*>(around);
        for (int tab = 0; tabs && tab < tabs->count(); ++tab) {
            if (tabs->widget(tab)->isAncestorOf(&widget)) {
                tabs->setCurrentIndex(tab);
            }
        }
    }
}

NumberField& fieldOf(const QWidget& window, const QString& accessible_name) {
    for (NumberField* each : window.findChildren<NumberField*>()) {
        if (each->accessibleName() == accessible_name) {
            return *each;
        }
    }
    qFatal("no such field: %s", qPrintable(accessible_name));
}

void typeInto(NumberField& field, const char* text) {
    field.setFocus();
    field.selectAll();
    QTest::keyClicks(&field, text);
    QTest::keyClick(&field, Qt::Key_Return);
}

std::unique_ptr<MainWindow> shownWindow() {
    QSettings().clear();
    QSettings().setValue(QStringLiteral("live"), false);
    auto window = std::make_unique<TestWindow>();
    window->setLanguage(QStringLiteral("en"));
    window->resize(1400, 900);
    window->show();
    if (!QTest::qWaitForWindowExposed(window.get())) {
        qFatal("the window does not appear");
    }
    return window;
}

bool WindowTest::idle(std::size_t analyses) {
    return QTest::qWaitFor(
        [&] { return !document().busy() && document().analyses().size() == analyses; }, 20000);
}

std::vector<RecordingId> WindowTest::ids() {
    std::vector<RecordingId> found;
    std::ranges::transform(document().recordings(), std::back_inserter(found), &RecordingEntry::id);
    return found;
}

bool WindowTest::allOpen() {
    return std::ranges::all_of(document().recordings(),
                               [](const auto& entry) { return entry.recording.has_value(); });
}

void WindowTest::openRuns(const QStringList& files) {
    document().open(files);
    QVERIFY(QTest::qWaitFor([&] { return allOpen() && !document().busy(); }, 20000));
}

QTableWidgetItem* WindowTest::cellOf(const QString& table, const QString& name, int column) {
    const auto& rows = the<QuantityTable>(table);
    for (int row = 0; row < rows.rowCount(); ++row) {
        if (rows.item(row, 0)->text().startsWith(name)) {
            return rows.item(row, column);
        }
    }
    return nullptr;
}

QTableWidgetItem* WindowTest::cellOf(const QString& table, const QString& name,
                                     const QString& header) {
    const auto& rows = the<QuantityTable>(table);
    for (int column = 1; column < rows.columnCount(); ++column) {
        const QTableWidgetItem* head = rows.horizontalHeaderItem(column);
        if (head && head->text() == header) {
            return cellOf(table, name, column);
        }
    }
    return nullptr;
}

bool dropFiles(QWidget& target, const QStringList& paths) {
    QMimeData data;
    QList<QUrl> urls;
    for (const QString& path : paths) {
        urls << QUrl::fromLocalFile(path);
    }
    data.setUrls(urls);
    // Qt sends the drop to the widget that has taken the drag.
    const QPoint at(20, 20);
    QDragEnterEvent enter(at, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QCoreApplication::sendEvent(&target, &enter);
    QDropEvent drop(at, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QCoreApplication::sendEvent(&target, &drop);
    return enter.isAccepted();
}

bool savedTo(MainWindow& window, const QString& path) {
    bool saved = false;
    window.session().save(path, [&saved] { saved = true; });
    return QTest::qWaitFor([&window] { return !window.session().isSaving(); }, 20000) && saved;
}

bool exportPlotsTo(MainWindow& window, const QString& path) {
    const FigureSource source = childOf<TracksPage>(window).figures();
    std::vector<int> all(static_cast<std::size_t>(source.plots.size()));
    std::iota(all.begin(), all.end(), 0);
    const Figure figure = source.figure(all);
    return window.files().writeFigure(figure, {figure.size}, path);
}

}  // namespace vybeg::ui
