// Every control of every page can be named, explained and reached by the Tab key, and no text is
// cut off, in both languages at the smallest size the program is made for.
#include "tests/test_registry.h"
#include "tests/ui/gui_test.h"
#include "tests/ui/resonator_runs.h"
#include "ui/batch/batch_window.h"
#include "ui/charts/round_plot.h"
#include "ui/plots/plot_view.h"
#include "ui/plots/signal_view.h"
#include "ui/plots/track_view.h"
#include "ui/widgets/number_field.h"
#include "ui/widgets/quantity_table.h"
#include "ui/window/export_dialogs.h"
#include "ui/words/rich_text.h"

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QApplication>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QRegularExpression>
#include <QStyleOption>
#include <QTabBar>
#include <QTableView>
#include <QTest>
#include <QToolBar>
#include <QTreeView>

#include <algorithm>

namespace test_accessibility {

using namespace vybeg;
using namespace vybeg::ui;

namespace {

constexpr QSize smallest(1280, 720);

bool isControl(const QWidget& widget) {
    const QWidget* parent = widget.parentWidget();
    const bool part =
        qobject_cast<const QComboBox*>(parent) || qobject_cast<const QTabBar*>(parent) ||
        qobject_cast<const QTableView*>(parent) || qobject_cast<const QLineEdit*>(parent) ||
        widget.objectName().startsWith("qt_") || qobject_cast<const QHeaderView*>(&widget);
    return !part &&
           (qobject_cast<const QAbstractButton*>(&widget) ||
            qobject_cast<const QLineEdit*>(&widget) || qobject_cast<const QComboBox*>(&widget) ||
            qobject_cast<const QAbstractItemView*>(&widget) ||
            qobject_cast<const TrackView*>(&widget) || qobject_cast<const SignalView*>(&widget) ||
            qobject_cast<const XYPlotView*>(&widget) || qobject_cast<const RoundView*>(&widget));
}

QString described(const QWidget& widget) {
    const auto* button = qobject_cast<const QAbstractButton*>(&widget);
    return QStringLiteral("%1 \"%2\" %3 in %4")
        .arg(widget.metaObject()->className(), widget.accessibleName(),
             button ? button->text() : widget.objectName(),
             widget.parentWidget() ? widget.parentWidget()->metaObject()->className() : "");
}

bool isNamed(const QWidget& widget) {
    const auto* button = qobject_cast<const QAbstractButton*>(&widget);
    return !widget.accessibleName().isEmpty() || (button && !button->text().isEmpty());
}

// What is missing of the controls in a window.
QStringList faultsOfControls(const QWidget& window) {
    QStringList faults;
    for (const QWidget* widget : window.findChildren<QWidget*>()) {
        if (!isControl(*widget) || !widget->isVisible()) {
            continue;
        }
        if (!isNamed(*widget)) {
            faults << "no name: " + described(*widget);
        }
        // The plots show values at the mouse, over which a tooltip would stand; standard buttons of
        // dialogs say all in their text.
        const bool shows_values =
            qobject_cast<const TrackView*>(widget) || qobject_cast<const SignalView*>(widget);
        const bool standard = qobject_cast<const QDialogButtonBox*>(widget->parentWidget());
        if (widget->toolTip().isEmpty() && !shows_values && !standard) {
            faults << "no tooltip: " + described(*widget);
        }
        // The tool bar repeats commands of the menus, and each plot of the tracks has a frame of
        // its own in the tab order.
        const bool elsewhere = qobject_cast<const QToolBar*>(widget->parentWidget()) ||
                               qobject_cast<const TrackView*>(widget);
        if (!elsewhere && widget->isEnabled() && !(widget->focusPolicy() & Qt::TabFocus)) {
            faults << "not reached by Tab: " + described(*widget);
        }
    }
    return faults;
}

// Cells and headers of a table or list of which a word, or where it does not wrap a text, is wider
// than its column; names of rows of a list may be shortened in the middle.
QStringList cutCells(const QAbstractItemView& view) {
    QStringList cut;
    const bool wraps = qobject_cast<const QuantityTable*>(&view) != nullptr;
    const auto* table = qobject_cast<const QTableView*>(&view);
    const auto* tree = qobject_cast<const QTreeView*>(&view);
    const QAbstractItemModel& model = *view.model();
    // Sentences wrap, numbers do not.
    const auto narrow = [&](const QString& text, double room) {
        static const QRegularExpression word(QStringLiteral("\\p{L}{2}"));
        const bool sentence = wraps && text.contains(word);
        const QStringList parts = sentence ? text.split(QLatin1Char(' ')) : QStringList{text};
        return std::ranges::any_of(
            parts, [&](const QString& part) { return indexTextWidth(part, view.font()) > room; });
    };
    for (int column = table ? 0 : 1; (table || tree) && column < model.columnCount(); ++column) {
        if (table ? table->isColumnHidden(column) : tree->isColumnHidden(column)) {
            continue;
        }
        const int width = table ? table->columnWidth(column) : tree->columnWidth(column);
        for (int row = 0; row < model.rowCount(); ++row) {
            const int span = table ? table->columnSpan(row, column) : 1;
            const QString text = model.index(row, column).data().toString();
            if (span == 1 && narrow(text, width)) {
                cut << QStringLiteral("cell \"%1\" in %2").arg(text, described(view));
            }
        }
        const QHeaderView* header = table ? table->horizontalHeader() : tree->header();
        const QString title = model.headerData(column, Qt::Horizontal).toString();
        const bool named = header->isVisible() && title != QString::number(column + 1);
        if (named && narrow(title, width)) {
            cut << QStringLiteral("header \"%1\" in %2").arg(title, described(view));
        }
    }
    return cut;
}

// Whether the number of a field, or what it shows in place of one, has less room than it needs.
bool isCut(const NumberField& field) {
    QStyleOptionFrame option;
    option.initFrom(&field);
    option.lineWidth = field.style()->pixelMetric(QStyle::PM_DefaultFrameWidth, &option, &field);
    const QMargins margins = field.textMargins();
    constexpr int inner = 4;  // of QLineEdit, both sides
    const int room =
        field.style()->subElementRect(QStyle::SE_LineEditContents, &option, &field).width() -
        margins.left() - margins.right() - inner;
    const QString text = field.text().isEmpty() ? field.placeholderText() : field.text();
    return field.fontMetrics().horizontalAdvance(text) > room;
}

bool isCut(const QComboBox& box) {
    QStyleOptionComboBox option;
    option.initFrom(&box);
    option.editable = box.isEditable();
    const QRect room = box.style()->subControlRect(QStyle::CC_ComboBox, &option,
                                                   QStyle::SC_ComboBoxEditField, &box);
    return box.fontMetrics().horizontalAdvance(box.currentText()) > room.width();
}

// Texts of labels, buttons, tabs, fields, boxes and tables that have less room than they need.
QStringList cutTexts(const QWidget& window) {
    QStringList cut;
    for (const QWidget* widget : window.findChildren<QWidget*>()) {
        if (!widget->isVisible()) {
            continue;
        }
        if (const auto* label = qobject_cast<const QLabel*>(widget);
            label && !label->text().isEmpty() && label->pixmap().isNull()) {
            const int height = label->wordWrap() ? label->heightForWidth(label->width())
                                                 : label->sizeHint().height();
            const bool narrow = !label->wordWrap() && label->sizeHint().width() > label->width();
            if (narrow || height > label->height()) {
                cut << QStringLiteral("label \"%1\" in %2")
                           .arg(label->text(), label->parentWidget()->metaObject()->className());
            }
        } else if (const auto* button = qobject_cast<const QAbstractButton*>(widget);
                   button && !button->text().isEmpty()) {
            const int needed = button->fontMetrics().horizontalAdvance(
                QString(button->text()).remove(QLatin1Char('&')));
            if (needed > button->width()) {
                cut << "button " + described(*button);
            }
        } else if (const auto* tabs = qobject_cast<const QTabBar*>(widget)) {
            for (int tab = 0; tab < tabs->count(); ++tab) {
                if (tabs->isTabVisible(tab) && tabs->fontMetrics().horizontalAdvance(tabs->tabText(
                                                   tab)) > tabs->tabRect(tab).width()) {
                    cut << "tab " + tabs->tabText(tab);
                }
            }
        } else if (const auto* field = qobject_cast<const NumberField*>(widget)) {
            if (isCut(*field)) {
                cut << QStringLiteral("field \"%1\" %2").arg(field->text(), described(*field));
            }
        } else if (const auto* box = qobject_cast<const QComboBox*>(widget)) {
            if (isCut(*box)) {
                cut << QStringLiteral("box \"%1\" %2").arg(box->currentText(), described(*box));
            }
        } else if (const auto* view = qobject_cast<const QAbstractItemView*>(widget)) {
            cut << cutCells(*view);
        }
    }
    return cut;
}

}  // namespace

class TestAccessibility : public QObject, private WindowTest {
    Q_OBJECT

    // Calls a function with the name of each state of a window of that size, on every page.
    template <class Function>
    void everywhere(const QSize& size, const Function& check) {
        window_->resize(size);
        for (const QString& language : {QStringLiteral("en"), QStringLiteral("ru")}) {
            window_->setLanguage(language);
            auto& pages = childOf<QTabBar>(*window_, "pages");
            for (int page = 0; page < pages.count(); ++page) {
                pages.setCurrentIndex(page);
                // Without and with the wave, where the page has one.
                for (int wave = 0; wave < 2; ++wave) {
                    window_->action(Command::wave)->trigger();
                    QCoreApplication::processEvents();
                    check(QStringLiteral("%1, page %2, wave %3").arg(language).arg(page).arg(wave));
                }
            }
        }
    }

private slots:
    void initTestCase() {
        window_ = shownWindow();
        window_->resize(smallest);
        Document& document = window_->document();
        document.open(resonatorRuns(home_, "HRG-17"));  // a set of four
        QTRY_VERIFY_WITH_TIMEOUT(!document.busy() && document.analyses().size() == 4, 60000);
        document.dossier().setLimits(
            {{"split_hz", std::nullopt, 0.0015}, {"tau_s", 25, std::nullopt}, {"q", 1e6, 2e6}});
        window_->action(Command::identify)->trigger();
        QTRY_VERIFY_WITH_TIMEOUT(!document.busy(), 60000);
        auto& tracks = childOf<TrackView>(*window_);
        tracks.setFocus();
        for (const auto& [time_s, key] : {std::pair{0.5, Qt::Key_1}, std::pair{1.5, Qt::Key_2}}) {
            tracks.setTracker(time_s);
            QTest::keyClick(&tracks, key);
        }
    }
    void cleanupTestCase() { window_.reset(); }

    void every_control_has_a_name_a_tooltip_and_a_place_in_the_tab_order() {
        QStringList faults;
        everywhere(smallest, [&](const QString&) { faults << faultsOfControls(*window_); });
        faults.removeDuplicates();
        for (const QString& fault : faults) {
            qWarning("%s", qPrintable(fault));
        }
        QVERIFY2(faults.isEmpty(), qPrintable(faults.join('\n')));
    }

    void so_has_every_control_of_the_export() {
        window_->action(Command::page_tracks)->trigger();
        window_->action(Command::export_plots)->trigger();
        auto& dialog = childOf<ExportDialog>(*window_);
        const QStringList faults = faultsOfControls(dialog) + cutTexts(dialog);
        dialog.reject();
        QVERIFY2(faults.isEmpty(), qPrintable(faults.join('\n')));
    }

    void so_has_every_control_of_the_batch() {
        window_->action(Command::batch)->trigger();
        auto& batch = childOf<BatchWindow>(*window_);
        QVERIFY(QTest::qWaitForWindowExposed(&batch));
        batch.resize(1000, 600);
        batch.form().setPath(BatchPath::list, home_.path("a.wav"));
        batch.form().setPath(BatchPath::results, home_.path("results.csv"));
        QStringList faults;
        for (const QString& language : {QStringLiteral("en"), QStringLiteral("ru")}) {
            window_->setLanguage(language);
            // A layout may take several turns of the event loop.
            if (!QTest::qWaitFor([&] { return cutTexts(batch).isEmpty(); }, 5000)) {
                faults << cutTexts(batch);
            }
            faults << faultsOfControls(batch);
        }
        batch.close();
        window_->setLanguage(QStringLiteral("en"));
        QVERIFY2(faults.isEmpty(), qPrintable(faults.join('\n')));
    }

    void no_text_is_cut_off_data() {
        QTest::addColumn<QSize>("size");
        QTest::newRow("smallest") << smallest;
        QTest::newRow("usual") << QSize(1920, 1080);
    }
    void no_text_is_cut_off() {
        QFETCH(QSize, size);
        QStringList cut;
        everywhere(size, [&](const QString& where) {
            // A layout may take several turns of the event loop.
            const bool whole = QTest::qWaitFor([&] { return cutTexts(*window_).isEmpty(); }, 5000);
            if (whole) {
                return;
            }
            for (const QString& text : cutTexts(*window_)) {
                cut << where + ": " + text;
            }
        });
        cut.removeDuplicates();
        for (const QString& text : cut) {
            qWarning("%s", qPrintable(text));
        }
        QVERIFY2(cut.isEmpty(), qPrintable(cut.join('\n')));
    }
};

VYBEG_TEST(TestAccessibility)

}  // namespace test_accessibility

#include "test_accessibility.moc"
