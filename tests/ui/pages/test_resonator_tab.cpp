// Sets of runs, their identification and the passport, through the window's own widgets.
#include "core/resonator/results/resonator_parameters.h"
#include "tests/closeness.h"
#include "tests/test_registry.h"
#include "tests/ui/gui_test.h"
#include "tests/ui/resonator_runs.h"
#include "ui/panels/ledger.h"
#include "ui/panels/message_bar.h"
#include "ui/plots/plot_view.h"
#include "ui/resonator/parameter_text.h"
#include "ui/resonator/resonator_page.h"
#include "ui/resonator/resonator_text.h"
#include "ui/resonator/set_panel.h"
#include "ui/settings/settings_groups.h"
#include "ui/widgets/number_field.h"
#include "ui/widgets/quantity_table.h"
#include "ui/window/file_commands.h"
#include "ui/words/error_text.h"
#include "ui/words/rich_text.h"

#include <QClipboard>
#include <QComboBox>
#include <QHeaderView>
#include <QLabel>
#include <QScrollBar>
#include <QTabWidget>
#include <QTest>
#include <QTextDocument>

namespace test_resonator_tab {

using namespace vybeg;
using namespace vybeg::ui;

class TestResonatorTab : public QObject, private WindowTest {
    Q_OBJECT

    QStringList files_;
    // With the identified set, while no function looks at it.
    std::unique_ptr<MainWindow> identified_;
    bool looks_only_ = false;

    SetStore& setStore() { return window_->document().sets(); }

    std::shared_ptr<const SetResult> outcome() {
        const RecordingSet* set = setStore().current();
        return set ? setStore().outcome(*set) : nullptr;
    }

    void identify() {
        window_->action(Command::identify)->trigger();
        QVERIFY(document().busy());
        QVERIFY(QTest::qWaitFor([&] { return !document().busy(); }, 60000));
        QVERIFY2(outcome(), qPrintable(the<MessageBar>().texts().join('\n')));
    }

    void openSet() {
        openRuns(files_);
        setStore().addToCurrent(ids());
    }

    // The window with the set as it is identified. The functions that only look at it share it, and
    // leave it as it is.
    void showIdentified() {
        looks_only_ = true;
        if (!identified_) {
            openSet();
            identify();
            return;
        }
        window_ = std::move(identified_);
        window_->show();
        window_->activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(window_.get()));
    }

    // The text of a table's row by the beginning of its name.
    QString cell(const QString& table, const QString& name, int column = 1) {
        const QTableWidgetItem* item = cellOf(table, name, column);
        return item ? item->text() : QStringLiteral("no row %1").arg(name);
    }

private slots:
    void initTestCase() { files_ = resonatorRuns(home_, "run"); }

    // Before an identification the hint has the middle of what is free.
    void an_empty_page_has_its_hint_in_the_middle() {
        openSet();
        window_->action(Command::page_resonator)->trigger();
        auto& page = the<ResonatorPage>();
        auto& panel = the<SetPanel>();
        const auto& hint = the<QLabel>("hint");
        QTRY_VERIFY(hint.isVisible());
        const int free = page.width() - panel.mapTo(&page, panel.rect().topRight()).x();
        const auto aside = [&] {
            return page.width() - hint.mapTo(&page, hint.rect().center()).x() - free / 2;
        };
        QTRY_VERIFY(std::abs(aside()) < 20);
    }

    void init() { window_ = shownWindow(); }
    void cleanup() {
        if (looks_only_ && !QTest::currentTestFailed()) {
            window_->hide();
            identified_ = std::move(window_);
        }
        window_.reset();
        looks_only_ = false;
    }
    void cleanupTestCase() { identified_.reset(); }

    // Where no damped sinusoid follows a swing, the split says how it beats.
    void the_beat_between_the_cursors_knows_the_split() {
        showIdentified();
        auto& ledger = the<Ledger>();
        ledger.setTrendKind(TrendKind::beat);
        ledger.setCursors(1, 2);
        const Estimate& split = outcome()->identification.fit.resonator.split_hz;
        QVERIFY(split.given());
        const QString value = valueText(split.value, split.uncertainty());
        const QTreeWidgetItem& row = *ledger.currentItem();
        QVERIFY2(row.toolTip(Ledger::trend).contains(richText(value)),
                 qPrintable(row.toolTip(Ledger::trend)));
        // The sentences stand below each other.
        QVERIFY(row.toolTip(Ledger::trend).contains("<br>") &&
                !row.toolTip(Ledger::trend).contains("&lt;"));
        ledger.setTrendKind(TrendKind::line);
        ledger.setCursors({}, {});
    }

    // In the smallest window, in both languages, with nothing to scroll.
    void all_parameters_of_a_set_are_seen_at_once() {
        showIdentified();
        window_->action(Command::page_resonator)->trigger();
        for (const char* language : {"en", "ru"}) {
            window_->resize(1920, 1080);
            window_->setLanguage(language);
            QTest::qWait(1);
            window_->resize(1280, 720);
            auto& table = the<QuantityTable>("resonator");
            QCOMPARE(table.rowCount(), static_cast<int>(resonator_parameters.size()));
            const auto seen = [&table] {
                const QRegion visible = table.viewport()->visibleRegion();
                for (int row = 0; row < table.rowCount(); ++row) {
                    const QRect whole = table.visualItemRect(table.item(row, 1)) |
                                        table.visualItemRect(table.item(row, 0));
                    if (QRegion(whole).subtracted(visible).boundingRect().height() > 0) {
                        return false;
                    }
                }
                return true;
            };
            QTRY_VERIFY2(seen(), language);
            // Neither do the columns scroll, nor the recordings below the parameters.
            for (QWidget* part : {static_cast<QWidget*>(&table),
                                  static_cast<QWidget*>(&the<QuantityTable>("waves")),
                                  static_cast<QWidget*>(&the<XYPlotView>("drift"))}) {
                bringUp(*part);
                for (QWidget* at = part; at != &the<ResonatorPage>(); at = at->parentWidget()) {
                    if (const auto* area = qobject_cast<QAbstractScrollArea*>(at)) {
                        const auto still = [area] {
                            return !area->verticalScrollBar()->isVisible() &&
                                   !area->horizontalScrollBar()->isVisible();
                        };
                        QTRY_VERIFY2(still(), qPrintable(part->objectName() + language));
                    }
                }
            }
        }
        window_->setLanguage(QStringLiteral("en"));
        window_->resize(1400, 900);
    }

    void four_runs_give_split_axis_and_decay() {
        showIdentified();
        const ResonatorEstimate& found = outcome()->identification.fit.resonator;
        const TestResonator truth;
        VYBEG_CLOSE(found.split_hz.value, truth.split_hz, 4 * found.split_hz.sd);
        VYBEG_CLOSE(found.theta_w_rad.value, truth.theta_w, 4 * found.theta_w_rad.sd);
        VYBEG_CLOSE(found.tau_s.value, truth.tau_s, 4 * found.tau_s.sd);
        const Estimate& split = found.split_hz;
        QCOMPARE(cell("resonator", "Frequency split"),
                 valueText(1e3 * split.value, 1e3 * split.sd));
        VYBEG_MORE(split.u, split.sd);
        QCOMPARE(cellOf("resonator", "Frequency split", "u")->text(),
                 uncertaintyLabel(1e3 * split.value, 1e3 * split.sd, 1e3 * split.u));
        QVERIFY(cell("resonator", "Decay time").startsWith("40"));
        QCOMPARE(the<QuantityTable>("runs").rowCount(), 4);
        QVERIFY(!the<XYPlotView>("drift").content().series.empty());
        QCOMPARE(the<XYPlotView>("balance").content().series.size(), std::size_t(4));
    }

    // One line for a parameter that is not given; its reason is told to everybody: by the mouse, by
    // the keyboard, to a screen reader, in a spreadsheet.
    void a_missing_parameter_has_a_word_and_its_reason() {
        showIdentified();
        window_->action(Command::page_resonator)->trigger();
        auto& table = the<QuantityTable>("resonator");
        auto& sentence = the<QLabel>("reason");
        const ResonatorEstimate& found = outcome()->identification.fit.resonator;
        QTextDocument shown;
        const auto said = [&] {
            shown.setHtml(sentence.text());
            return shown.toPlainText();
        };
        const auto& zero = *cellOf("resonator", "Non-orthogonality", 1);
        const auto& bound = *cellOf("resonator", "Amplitude dependence", 1);
        QCOMPARE(zero.text(), QStringLiteral("taken as zero *"));
        QVERIFY2(bound.text().startsWith("≤ "), qPrintable(bound.text()));
        QCOMPARE(table.rowHeight(zero.row()), table.rowHeight(0));
        QVERIFY(sentence.isVisible());
        QVERIFY2(said().contains(reasonText(found.damping_anisotropy_per_s.reason)),
                 qPrintable(said()));
        QVERIFY(cell("resonator", "Damping anisotropy").startsWith("≤ "));
        QCOMPARE(cell("resonator", "Damping axis"), QStringLiteral("no axis *"));
        const int height = sentence.height();
        table.setFocus();
        table.setCurrentCell(bound.row(), 0);
        QVERIFY2(said().contains(reasonText(found.frequency_per_power.reason)), qPrintable(said()));
        table.setCurrentCell(zero.row() + 1, 1);
        QVERIFY2(said().startsWith("* δ: Taken as zero"), qPrintable(said()));
        QCOMPARE(sentence.height(), height);
        QVERIFY(bound.toolTip().contains("no dependence"));
        QVERIFY(bound.data(Qt::AccessibleTextRole).toString().contains("no dependence"));
        QTest::keyClick(&table, Qt::Key_C, Qt::ControlModifier);
        QVERIFY(QApplication::clipboard()->text().contains("no dependence"));
        table.setCurrentItem(nullptr);
    }

    // Below the title of its plot, in full as the tip, to copy with all digits.
    void the_harmonics_of_the_drift_are_a_sentence() {
        showIdentified();
        window_->action(Command::page_resonator)->trigger();
        auto& sentence = the<QLabel>("harmonics");
        DisplayUnits units;
        units.angle = AngleUnit::degrees;
        the<ResonatorPage>().setUnits(units);
        Estimate mean = outcome()->identification.drift.coefficient(0);
        for (double* part : {&mean.value, &mean.sd, &mean.u}) {
            *part *= angleRateFactor(units);
        }
        QVERIFY(sentence.isVisible());
        QVERIFY2(sentence.text().contains(richText(conciseText(mean.value, mean.sd))),
                 qPrintable(sentence.text()));
        QVERIFY2(sentence.toolTip().contains(richText(valueText(mean.value, mean.sd, mean.u))),
                 qPrintable(sentence.toolTip()));
        sentence.actions().constFirst()->trigger();
        const QStringList lines = QApplication::clipboard()->text().split('\n');
        QCOMPARE(lines.size(), 5);
        QCOMPARE(lines.at(1).split('\t').at(1).toDouble(), mean.value);
    }

    void the_table_is_copied_for_a_spreadsheet() {
        showIdentified();
        auto& table = the<QuantityTable>("resonator");
        table.setFocus();
        QTest::keyClick(&table, Qt::Key_C, Qt::ControlModifier);
        const QStringList lines = QApplication::clipboard()->text().split('\n');
        QCOMPARE(lines.front(), QStringLiteral("\tValue\tsd\tu"));
        const QStringList split = lines.at(2).split('\t');
        QCOMPARE(split.size(), 4);
        QVERIFY(split.front().startsWith("Frequency split") && split.front().endsWith("mHz"));
        const Estimate& found = outcome()->identification.fit.resonator.split_hz;
        QCOMPARE(split.at(1).toDouble(), 1e3 * found.value);
        QCOMPARE(split.at(2).toDouble(), 1e3 * found.sd);
        QCOMPARE(split.at(3).toDouble(), 1e3 * found.u);
    }

    // Below the parameters stands what each recording's wave did, free of the model; sd is never
    // mistaken for all.
    void parameters_stand_first_then_waves_and_sensitivities() {
        showIdentified();
        const Identification& found = outcome()->identification;
        auto& waves = the<QuantityTable>("waves");
        auto& resonator = the<QuantityTable>("resonator");
        auto& sensitivities = the<QuantityTable>("sensitivities");
        const auto top = [this](QWidget& widget) {
            bringUp(widget);
            return widget.mapTo(&the<ResonatorPage>(), QPoint()).y();
        };
        VYBEG_LESS(top(resonator), top(sensitivities));
        auto& tabs = the<QTabWidget>("outcomeTabs");
        VYBEG_MORE(tabs.currentIndex(), 0);
        VYBEG_LESS(top(resonator), top(waves));
        QCOMPARE(tabs.currentIndex(), 0);
        QCOMPARE(waves.rowCount(), 4);
        // A recording is a row, a quantity a column, of which the tip has the whole number.
        QCOMPARE(waves.columnCount(), 6);
        QCOMPARE(waves.horizontalHeaderItem(1)->text(),
                 QStringLiteral("Frequency of the wave, Hz"));
        const Estimate& f = found.runs[2].wave.f_hz;
        QCOMPARE(waves.item(2, 1)->text(), conciseText(f.value, f.sd));
        QCOMPARE(waves.item(2, 1)->toolTip(), richTip(valueText(f.value, f.sd, f.u)));
        QVERIFY(waves.item(2, 0)->text().endsWith("45"));
        QVERIFY(waves.item(2, 0)->toolTip().contains("run-45.wav"));
        double chi2 = 0;
        for (const RunEstimate& run : found.fit.runs) {
            chi2 += run.chi2_per_dof / 4;  // of as many windows each
        }
        VYBEG_CLOSE_RATIO(chi2, found.fit.chi2_per_dof, 1e-3);
        QCOMPARE(waves.item(2, 5)->text(), numberLabel(found.fit.runs[2].chi2_per_dof, 2));
        // An error is a row, a parameter a column.
        QCOMPARE(sensitivities.rowCount(), 11);
        VYBEG_AT_LEAST(sensitivities.columnCount(), 6);
        // Titles take as many lines as they need.
        const QHeaderView& titles = *sensitivities.horizontalHeader();
        for (int column = 1; column < sensitivities.columnCount(); ++column) {
            const QString title = sensitivities.horizontalHeaderItem(column)->text();
            const QRect room(0, 0, titles.sectionSize(column) - 8, QWIDGETSIZE_MAX);
            const QRect needed = titles.fontMetrics().boundingRect(room, Qt::TextWordWrap, title);
            VYBEG_AT_MOST(needed.width(), room.width(), qPrintable(title));
            VYBEG_AT_MOST(needed.height(), titles.height(), qPrintable(title));
        }
        // Copied, the change of the axis by 0.1 degrees of skew.
        bringUp(sensitivities);
        sensitivities.setFocus();
        QTest::keyClick(&sensitivities, Qt::Key_C, Qt::ControlModifier);
        const QStringList lines = QApplication::clipboard()->text().split('\n');
        const auto axis = lines.front().split('\t').indexOf("θw, °");
        VYBEG_MORE(axis, 0);
        QVERIFY(lines.at(1).startsWith("0.1° of non-orthogonality"));
        QCOMPARE(lines.at(1).split('\t').at(axis).toDouble(),
                 0.1 * found.fit.sensitivities[2][skew_error] * 180 / std::numbers::pi);
        for (const QuantityRow& row : sensitivityRows(found, {})) {
            QVERIFY2(!row.cells[0].exact[0].isEmpty(), qPrintable(row.name));
        }
    }

    void tolerances_are_edited_undone_and_enter_u() {
        openSet();
        identify();
        auto& statistical = the<QLabel>("statistical");
        QVERIFY(statistical.toolTip().contains("Non-orthogonality (assumed): 0.1°"));
        QVERIFY(!statistical.text().contains("Non-orthogonality"));
        QVERIFY(statistical.text().contains("some assumed"));
        QVERIFY(statistical.text().contains("clock of the recorder"));
        emit statistical.linkActivated("fold");
        QVERIFY(statistical.text().contains("Non-orthogonality (assumed): 0.1°"));
        auto& section = the<CalibrationFields>();
        const auto field = [&section](const QString& name) {
            const auto all = section.findChildren<NumberField*>();
            return *std::ranges::find(all, name, &QWidget::accessibleName);
        };
        const auto type = [&](const QString& name, const QString& text) {
            field(name)->setText(text);
            field(name)->setModified(true);  // as by the keyboard
            field(name)->commit();
        };
        QCOMPARE(field("Tolerance of the gain ratio")->placeholderText(), QStringLiteral("0.01"));
        for (const auto& [of, text] : {std::pair{"gain drift", "0.01"},
                                       {"delay", "10"},
                                       {"non-orthogonality", "0.5"},
                                       {"phase drift", "0.001"},
                                       {"crosstalk", "0.0001"},
                                       {"sample rate", "2"},
                                       {"spread between recordings", "0.004"},
                                       {"gain ratio", "0.002"}}) {
            type(QStringLiteral("Tolerance of the ") + of, text);
        }
        const Tolerance wanted{0.002, 0.5, 10e-9, 1e-4, 1e-3, 0.01, 2, 0.004};
        QCOMPARE(QString::fromStdString(tolerance_text(document().tolerance())),
                 QString::fromStdString(tolerance_text(wanted)));
        QVERIFY(the<QLabel>("state").text().contains("Out of date"));
        identify();
        QCOMPARE(tolerance_text(outcome()->identification.settings.tolerance),
                 tolerance_text(wanted));
        QVERIFY(!the<QLabel>("statistical").text().contains("assumed"));
        QVERIFY(!the<QLabel>("statistical").text().contains("clock of the recorder"));
        const Estimate& tau = outcome()->identification.fit.resonator.tau_s;
        VYBEG_MORE(tau.u, tau.sd);
        QCOMPARE(cellOf("resonator", "Decay time", "u")->text(),
                 uncertaintyLabel(tau.value, tau.sd, tau.u));
        document().undoStack().undo();
        QVERIFY(!document().tolerance()[kappa_error]);
        QVERIFY(field("Tolerance of the gain ratio")->text().isEmpty());
        field("Tolerance of the delay")->setText("-1");
        QVERIFY(!field("Tolerance of the delay")->isValid());
    }

    void one_still_run_says_what_it_cannot_tell_and_what_would_help() {
        // A quadrature so small that an unseen anisotropy makes nothing of it.
        openRuns({resonatorRuns(home_, "still", {.split_hz = 1e-6})[1]});
        window_->action(Command::identify)->trigger();  // no set: one of the current recording
        QVERIFY(QTest::qWaitFor([&] { return !document().busy() && outcome(); }, 60000));
        QCOMPARE(setStore().current()->recordings, ids());
        for (const char* row : {"Mean frequency", "Frequency split", "Stiffness axis"}) {
            QCOMPARE(cell("resonator", row), QStringLiteral("— *"));
            const QString reason = cellOf("resonator", row, 1)->toolTip();
            QVERIFY2(reason.contains("Add a recording that starts at"), qPrintable(reason));
        }
        // The direction in which the wave stands is seen all the same.
        window_->action(Command::page_resonator)->trigger();
        auto& directions = the<QuantityTable>("directions");
        bringUp(directions);
        for (const char* head : {"f of this direction, Hz", "τ of this direction, s"}) {
            const QTableWidgetItem* value = cellOf("directions", "● still", head);
            QVERIFY2(value, head);
            QVERIFY2(value->toolTip().contains("±"), qPrintable(value->text()));
        }
    }

    void a_running_identification_is_cancelled() {
        openSet();
        window_->action(Command::identify)->trigger();
        QVERIFY(document().busy());
        window_->action(Command::cancel)->trigger();
        QVERIFY(QTest::qWaitFor([&] { return !document().busy(); }, 20000));
        QVERIFY(!outcome());
        QVERIFY(the<MessageBar>().texts().isEmpty());
    }

    void an_edit_stops_the_identification_and_nothing_stale_arrives() {
        openSet();
        window_->action(Command::identify)->trigger();
        setStore().removeFrom(setStore().current()->id, {ids().front()});
        QVERIFY(!document().busy());
        QVERIFY(!outcome());
        // Analyses and identifications compute one after the other: by the end of this analysis the
        // identification has ended.
        document().analyse();
        QVERIFY(document().busy());
        QVERIFY(QTest::qWaitFor([&] { return !document().busy(); }, 60000));
        QVERIFY(!outcome());
    }

    void an_edit_marks_the_result_as_out_of_date() {
        openSet();
        identify();
        QVERIFY(!the<QLabel>("state").text().contains("Out of date"));
        QVERIFY(window_->action(Command::save_passport)->isEnabled());
        setStore().removeFrom(setStore().current()->id, {ids().front()});
        QVERIFY(the<QLabel>("state").text().contains("Out of date"));
        QVERIFY(!window_->action(Command::save_passport)->isEnabled());
        QCOMPARE(the<QuantityTable>("runs").rowCount(), 4);  // what was found stays
        setStore().addToCurrent({ids().front()});  // now the last one: the order does not matter
        QVERIFY(!the<QLabel>("state").text().contains("Out of date"));
        Settings settings = document().settings();
        settings.calibration.angle_zero_deg = 3;
        document().setSettings(settings);
        QVERIFY(the<QLabel>("state").text().contains("Out of date"));
        document().undoStack().undo();
        QVERIFY(!the<QLabel>("state").text().contains("Out of date"));
    }

    void results_of_both_models_are_kept_while_the_set_stays() {
        openSet();
        identify();
        const auto structured = outcome();
        const auto id = setStore().current()->id;
        setStore().setModel(id, FitOptions::Model::free);
        QVERIFY(setStore().outOfDate(*setStore().current(), *outcome()));
        identify();
        QCOMPARE(outcome()->identification.fit.model, ResonatorModel::free);
        setStore().setModel(id, FitOptions::Model::automatic);
        QCOMPARE(outcome(), structured);
    }

    void a_passport_finds_what_has_changed() {
        openSet();
        identify();
        window_->files().savePassportTo(home_.path("gyro.json"));
        QVERIFY(QTest::qWaitFor([&] { return QFile::exists(home_.path("gyro.json")); }));
        document().passport().open(home_.path("gyro.json"));
        QVERIFY(QTest::qWaitFor([&] { return document().passport().content() != nullptr; }));
        QCOMPARE(cell("differences", "Frequency split"), QStringLiteral("= unchanged"));
        QCOMPARE(cell("differences", "Frequency split", 2), QStringLiteral("0.0"));
        QVERIFY(cell("differences", "Mean frequency", 4).endsWith("ppm") ||
                cell("differences", "Mean frequency", 4).endsWith("%"));
        QCOMPARE(the<QuantityTable>("differences").columnCount(), 6);

        const QStringList later = resonatorRuns(home_, "later", {.split_hz = 0.02});
        setStore().add();
        document().openIntoSet(later);
        QVERIFY(QTest::qWaitFor([&] { return allOpen() && !document().busy(); }, 20000));
        identify();
        QCOMPARE(cell("differences", "Frequency split"), QStringLiteral("≠ changed"));
        QVERIFY(
            cellOf("resonator", "Frequency split", "Since the passport")->text().startsWith("≠ "));
        QVERIFY(cellOf("resonator", "Decay time", "Since the passport")->text().startsWith("= "));
        QCOMPARE(cell("differences", "Decay time"), QStringLiteral("= unchanged"));
        QVERIFY2(cell("differences", "Frequency split", 4).contains("%"),
                 qPrintable(cell("differences", "Frequency split", 4)));
        QCOMPARE(document().passport().input().f_limit_ppm, 30.0);
        QCOMPARE(the<XYPlotView>("tracks").content().series.size(), std::size_t(8));
        document().passport().close();
        QVERIFY(!the<QuantityTable>("differences").isVisible());
    }

    void a_damaged_passport_is_told_of() {
        document().passport().open(home_.file("bad.json", "{"));
        QVERIFY(QTest::qWaitFor([&] { return !the<MessageBar>().texts().isEmpty(); }));
        QVERIFY(the<MessageBar>().texts().first().contains("bad.json"));
        QVERIFY(!document().passport().content());
    }

    void plots_go_into_files_and_to_the_clipboard() {
        showIdentified();
        const XYPlot plot = the<XYPlotView>("drift").content();
        for (const char* name : {"drift.png", "drift.svg", "drift.pdf"}) {
            QVERIFY(writeDrawing(xyDrawing(plot), {{400, 300}}, home_.path(name)));
            VYBEG_MORE(QFileInfo(home_.path(name)).size(), 1000);
        }
        auto& view = the<XYPlotView>("balance");
        bringUp(view);
        view.setFocus();
        QTest::keyClick(&view, Qt::Key_C, Qt::ControlModifier);
        QVERIFY(!QApplication::clipboard()->image().isNull());
    }

    void angles_follow_the_units_of_display() {
        showIdentified();
        DisplayUnits units;
        units.angle = AngleUnit::degrees;
        const auto rows = resonatorRows(outcome()->identification, units);
        QVERIFY(std::ranges::none_of(rows, [](const auto& row) { return row.tip.isEmpty(); }));
        const auto& axis = rows.at(2);
        QVERIFY(axis.name.endsWith("°"));
        VYBEG_CLOSE(axis.cells.front().exact.front().toDouble(), 11.46, 2);
        the<ResonatorPage>().setUnits(units);
        QCOMPARE(cell("resonator", "Stiffness axis"), axis.cells.front().text);
        the<ResonatorPage>().setUnits({});
    }
};

VYBEG_TEST(TestResonatorTab, threads)

}  // namespace test_resonator_tab

#include "test_resonator_tab.moc"
