// The analysis panel as a person uses it: what is typed, and what comes of it.
#include "tests/closeness.h"
#include "tests/test_registry.h"
#include "tests/ui/gui_test.h"
#include "ui/panels/ledger.h"
#include "ui/settings/settings_panel.h"
#include "ui/widgets/page_parts.h"
#include "ui/window/tracks_page.h"

#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QSignalSpy>
#include <QTest>
#include <QWheelEvent>

#include <tuple>

namespace test_settings_panel {

using namespace vybeg;
using namespace vybeg::ui;

class TestSettingsPanel : public QObject, private WindowTest {
    Q_OBJECT

    void openOne() {
        document().open({home_.recording("demo.wav")});
        QVERIFY(idle(1));
        QVERIFY(QTest::qWaitFor([&] { return document().carrier().has_value(); }));
    }

    // What the panel says beside its fields.
    QStringList faults() {
        QStringList texts;
        for (const QLabel* label : window_->findChildren<QLabel*>(QStringLiteral("fault"))) {
            if (label->isVisible()) {
                texts << label->text();
            }
        }
        return texts;
    }

private slots:
    void init() { window_ = shownWindow(); }
    void cleanup() { window_.reset(); }

    void half_and_reversed_bands_say_so_and_hold_up_the_run_data() {
        QTest::addColumn<QString>("from");
        QTest::addColumn<QString>("to");
        QTest::addColumn<bool>("filter");
        QTest::newRow("search") << "Search from"
                                << "Search to" << false;
        QTest::newRow("filter") << "Filter from"
                                << "Filter to" << true;
    }
    void half_and_reversed_bands_say_so_and_hold_up_the_run() {
        QFETCH(QString, from);
        QFETCH(QString, to);
        QFETCH(bool, filter);
        openOne();
        const auto band = [&] {
            return filter ? document().settings().filter : document().settings().band;
        };
        const auto stays = [&](const char* sentence) {
            QCOMPARE(faults(), QStringList{QStringLiteral("Not in effect: ") + sentence});
            field("Length").setFocus();
            QTest::keyClick(window_.get(), Qt::Key_F5);
            QVERIFY(!document().busy());
            QVERIFY(field(to).hasFocus());
            QVERIFY(!band());
        };
        typeInto(field(from), "900");
        stays("Both frequencies are needed.");
        typeInto(field(to), "800");
        stays("The second frequency must be above the first.");
        typeInto(field("Length"), "80");
        QCOMPARE(field(to).value(), std::optional(800.0));
        stays("The second frequency must be above the first.");
        typeInto(field(to), "x");
        stays("“x” is no number.");
        typeInto(field(to), "1100");
        QVERIFY(faults().isEmpty());
        QVERIFY(band() == (Band{900, 1100}));
        QTest::keyClick(window_.get(), Qt::Key_F5);
        QVERIFY(idle(2));
    }

    void a_band_mended_to_what_it_was_takes_its_other_half_along() {
        typeInto(field("Filter from"), "900");
        typeInto(field("Filter to"), "1100");
        typeInto(field("Filter from"), "9x");
        typeInto(field("Filter to"), "1200");
        QVERIFY(document().settings().filter == (Band{900, 1100}));
        typeInto(field("Filter from"), "900");
        QVERIFY(document().settings().filter == (Band{900, 1200}));
        QVERIFY(faults().isEmpty());
    }

    void keys_of_the_window_work_while_a_field_has_the_focus() {
        openOne();
        for (const auto& [command, key, modifiers] :
             {std::tuple{Command::export_plots, Qt::Key_E,
                         Qt::KeyboardModifiers(Qt::ControlModifier)},
              std::tuple{Command::live, Qt::Key_L, Qt::KeyboardModifiers(Qt::ControlModifier)},
              std::tuple{Command::zoom_fit, Qt::Key_0, Qt::KeyboardModifiers(Qt::ControlModifier)},
              std::tuple{Command::analyse, Qt::Key_F5, Qt::KeyboardModifiers()}}) {
            // What a command does has tests of its own: here it is only seen that it is called.
            QAction* const action = window_->action(command);
            QObject::disconnect(action, &QAction::triggered, window_.get(), nullptr);
            QSignalSpy called(action, &QAction::triggered);
            field("Length").setFocus();
            QTest::keyClick(&field("Length"), key, modifiers);
            QCOMPARE(called.count(), 1);
        }
    }

    void undo_in_a_field_takes_back_its_typing_and_then_the_settings() {
        NumberField& length = field("Length");
        typeInto(length, "80");
        typeInto(length, "90");
        QTest::keyClick(&length, Qt::Key_Z, Qt::ControlModifier);
        QCOMPARE(document().settings().window, 80);
        QTest::keyClick(&length, Qt::Key_End);
        QTest::keyClicks(&length, "7");
        QCOMPARE(length.text(), QStringLiteral("807"));
        QTest::keyClick(&length, Qt::Key_Z, Qt::ControlModifier);
        QCOMPARE(length.text(), QStringLiteral("80"));
        QCOMPARE(document().settings().window, 80);
        QTest::keyClick(&length, Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
        QCOMPARE(length.text(), QStringLiteral("807"));
        QTest::keyClick(&length, Qt::Key_Z, Qt::ControlModifier);
        QTest::keyClick(&length, Qt::Key_Z, Qt::ControlModifier);
        QCOMPARE(document().settings().window, 60);
        QCOMPARE(length.text(), QStringLiteral("60"));
        QTest::keyClick(&length, Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
        QTest::keyClick(&length, Qt::Key_Y, Qt::ControlModifier);
        QCOMPARE(document().settings().window, 90);
    }

    void the_wheel_changes_only_the_choice_that_has_the_focus() {
        window_->resize(1000, 500);  // the panel is longer than that
        auto& algorithm = childOf<QComboBox>(*window_, "algorithm");
        auto* const panel = childOf<SettingsPanel>(*window_).findChild<QScrollArea*>();
        QScrollBar* const bar = panel->verticalScrollBar();
        QVERIFY(QTest::qWaitFor([&] { return bar->maximum() > 0; }));
        const auto turn = [](QWidget& over) {
            const QPointF middle(over.rect().center());
            QWheelEvent wheel(middle, over.mapToGlobal(middle), {}, QPoint(0, -120), Qt::NoButton,
                              Qt::NoModifier, Qt::NoScrollPhase, false);
            // As from the system: others are not passed on to the parent.
            QSpontaneKeyEvent::setSpontaneous(&wheel);
            qApp->notify(&over, &wheel);
        };
        for (Section* section : panel->findChildren<Section*>()) {
            section->setOpen(true);
        }
        Settings settings = document().settings();
        settings.algorithm = Algorithm::conjugate_gradient;  // lets its start values be chosen
        document().setSettings(settings);
        for (QComboBox* choice : panel->findChildren<QComboBox*>()) {
            bar->setValue(0);
            window_->setFocus();
            const int chosen = choice->currentIndex();
            turn(*choice);
            QCOMPARE(choice->currentIndex(), chosen);
            VYBEG_MORE(bar->value(), 0);
            QVERIFY2(!choice->hasFocus(), "the wheel takes the focus");
        }
        QCOMPARE(document().settings(), settings);
        bar->setValue(0);
        algorithm.setCurrentIndex(0);
        algorithm.setFocus();
        turn(algorithm);
        QCOMPARE(algorithm.currentIndex(), 1);
        QCOMPARE(bar->value(), 0);
    }

    // Groups are opened in one language and shown in the other, in both orders.
    void no_field_of_an_open_group_is_cut() {
        openOne();
        auto& panel = childOf<SettingsPanel>(*window_);
        const auto* const area = panel.findChild<QScrollArea*>();
        const auto fits = [&] {
            return area->widget()->minimumSizeHint().width() <= area->viewport()->width();
        };
        for (const bool open : {true, false, true}) {
            for (Section* section : panel.findChildren<Section*>()) {
                section->setOpen(open);
            }
            QVERIFY(QTest::qWaitFor(fits));
            for (const char* language : {"ru", "en", "ru"}) {
                window_->setLanguage(QLatin1String(language));
                QVERIFY2(QTest::qWaitFor(fits), language);
            }
        }
        VYBEG_AT_MOST(panel.width(), 300);  // the plots own the window
    }

    void no_label_of_a_field_is_cut() {
        openOne();
        auto& panel = childOf<SettingsPanel>(*window_);
        for (Section* section : panel.findChildren<Section*>()) {
            section->setOpen(true);
        }
        for (const char* language : {"en", "ru", "en"}) {
            window_->setLanguage(QLatin1String(language));
            for (const auto* each : panel.findChildren<NumberField*>()) {
                for (const auto* label : each->parentWidget()->findChildren<QLabel*>()) {
                    if (label->buddy() == each) {
                        const auto fits = [label] {
                            return label->width() >= label->sizeHint().width() &&
                                   label->height() >= label->heightForWidth(label->width());
                        };
                        QVERIFY2(QTest::qWaitFor(fits, 2000), qPrintable(label->text()));
                        VYBEG_AT_MOST(label->height(), each->height());
                    }
                }
            }
        }
    }

    // Without being opened.
    void a_folded_section_says_what_is_chosen_in_it() {
        openOne();
        auto& panel = childOf<SettingsPanel>(*window_);
        Section& calibration = *panel.findChildren<Section*>().last();
        const auto note = [&](const QString& text) {
            const auto labels =
                calibration.findChildren<QLabel*>(QString(), Qt::FindDirectChildrenOnly);
            return std::ranges::any_of(labels, [&](const QLabel* label) {
                return label->isVisible() && label->text().contains(text);
            });
        };
        calibration.setOpen(false);
        QVERIFY(note("κ 1 ± 0.01"));
        Settings settings = document().settings();
        settings.calibration.kappa = 1.02;
        document().setSettings(settings);
        QVERIFY(note("κ 1.02 ± "));
        calibration.setOpen(true);
        QVERIFY(!note("κ"));
    }

    void plots_older_than_the_panel_say_so_until_they_are_analysed() {
        openOne();
        const auto& mark = childOf<QLabel>(*window_, "stale");
        const auto shown = [&](bool wanted) {
            return QTest::qWaitFor([&] { return mark.isVisible() == wanted; });
        };
        QVERIFY(shown(false));
        typeInto(field("Length"), "80");
        QVERIFY(shown(true));
        QCOMPARE(mark.text(),
                 QStringLiteral("The plots are older than these settings. Changed since: "
                                "window."));
        typeInto(field("Range from"), "0.5");
        QVERIFY(QTest::qWaitFor([&] { return mark.text().endsWith("window, range."); }));
        window_->action(Command::undo)->trigger();
        window_->action(Command::undo)->trigger();
        QVERIFY2(shown(false), "what the plots show is what the panel says");
        window_->action(Command::redo)->trigger();
        QVERIFY(shown(true));
        QTest::mouseClick(&childOf<QPushButton>(*window_, "analyse"), Qt::LeftButton);
        QVERIFY(idle(2));
        QVERIFY(shown(false));
        document().setAnalysisVisible(document().analyses().back().shown.id, false);
        QVERIFY2(shown(true), "what has the panel's settings is hidden");
        document().setLive(true);
        QVERIFY(idle(2));
        typeInto(field("Length"), "44");
        QVERIFY(idle(3));
        QVERIFY2(shown(false), "Live follows");
    }
};

VYBEG_TEST(TestSettingsPanel)

}  // namespace test_settings_panel

#include "test_settings_panel.moc"
