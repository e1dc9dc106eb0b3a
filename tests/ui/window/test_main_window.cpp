// The window driven as a person drives it: files, keys, mouse.
#include "tests/closeness.h"
#include "tests/test_registry.h"
#include "tests/ui/gui_test.h"
#include "ui/import/import_dialog.h"
#include "ui/panels/findings_flag.h"
#include "ui/panels/ledger.h"
#include "ui/panels/message_bar.h"
#include "ui/plots/signal_view.h"
#include "ui/plots/track_view.h"
#include "ui/settings/settings_panel.h"
#include "ui/widgets/number_field.h"
#include "ui/window/export_dialogs.h"
#include "ui/window/file_commands.h"
#include "ui/window/help.h"
#include "ui/window/main_window.h"
#include "ui/window/window_menus.h"

#include <QClipboard>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QFileDialog>
#include <QLabel>
#include <QLineEdit>
#include <QMimeData>
#include <QPushButton>
#include <QSignalSpy>
#include <QTest>
#include <QTextBrowser>
#include <QToolTip>
#include <qcustomplot.h>

#include <cmath>

namespace test_main_window {

using namespace vybeg;
using namespace vybeg::ui;

class TestMainWindow : public QObject, private WindowTest {
    Q_OBJECT

    void openOne(const QString& name = "demo.wav") {
        document().open({home_.recording(name)});
        QVERIFY(idle(1));
        QVERIFY(QTest::qWaitFor([&] { return document().carrier().has_value(); }));
    }

private slots:
    void init() { window_ = shownWindow(); }
    void cleanup() { window_.reset(); }

    void files_are_opened_by_dropping_them() {
        QVERIFY(dropFiles(*window_, {home_.recording("drop1.wav"), home_.recording("drop2.wav")}));
        QVERIFY(idle(2));
        QCOMPARE(the<TrackView>().analyses().size(), std::size_t(2));
        QCOMPARE(the<TrackView>().shownVariables().size(), std::size_t(5));
    }

    void two_files_of_one_channel_dropped_together_are_one_recording() {
        const QTemporaryDir folder;
        QStringList files;
        for (const char* name : {"run_D.csv", "run_C.csv"}) {
            QFile file(folder.filePath(name));
            QVERIFY(file.open(QIODevice::WriteOnly));
            file.write("t,U\n");
            for (int i = 0; i < 4000; ++i) {
                const double shift = QByteArray(name) == "run_C.csv" ? 0 : 0.2;
                file.write(QByteArray::number(1e-4 * i, 'f', 6) + ',' +
                           QByteArray::number(std::cos(0.9 * i + shift), 'f', 6) + '\n');
            }
            files << folder.filePath(name);
        }
        QVERIFY(dropFiles(*window_, files));
        QTRY_VERIFY(window_->findChild<ImportDialog*>());
        auto& dialog = the<ImportDialog>();
        auto* open = dialog.findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Open);
        QTRY_VERIFY(open->isEnabled());
        open->click();
        QVERIFY(idle(1));
        const auto& recordings = document().recordings();
        QCOMPARE(recordings.size(), std::size_t(1));
        QCOMPARE(recordings[0].name, QString("run_C.csv"));
        QCOMPARE(recordings[0].options.channel_d_file, folder.filePath("run_D.csv").toStdString());
    }

    void leakage_that_limits_the_mean_stands_in_the_row_with_its_cure() {
        openOne();
        auto& list = the<Ledger>();
        const auto notes_of = [&list](int row) {
            const auto& item = *list.topLevelItem(row);
            return item.data(list.notesColumn(), Qt::AccessibleTextRole).toString();
        };
        // 60 samples are 15 half-periods.
        QCOMPARE(list.topLevelItemCount(), 1);
        QVERIFY2(notes_of(0).isEmpty(), qPrintable(notes_of(0)));
        QCOMPARE(list.headerItem()->text(list.noiseColumn()), QString("Noise"));
        const QString text = list.topLevelItem(0)->text(list.noiseColumn());
        VYBEG_CLOSE_RATIO(readNumber(text).value_or(0), 1e-3, 0.05, qPrintable(text));

        Settings settings = document().settings();
        settings.window = 62;
        settings.algorithm = Algorithm::demodulation;
        document().setSettings(settings);
        document().analyse();
        QVERIFY(idle(2));
        const AnalysisEntry& entry = document().analyses().back();
        QVERIFY(entry.summary.leakage_limits());
        VYBEG_CLOSE(entry.summary.mean_f_hz, 1000, 4 * entry.summary.sd_mean_f_hz);
        QVERIFY2(notes_of(1).contains("Leakage"), qPrintable(notes_of(1)));
        auto* snap = list.findChild<QPushButton*>(QStringLiteral("snapAnalysis"));
        QVERIFY(snap && snap->isVisible());
        QTest::mouseClick(snap, Qt::LeftButton);
        QVERIFY(idle(3));
        const AnalysisEntry& snapped = document().analyses().back();
        QCOMPARE(snapped.shown.analysis->plan.length % 4, 0);
        QVERIFY(snapped.requested.snap && document().settings().snap);
        QVERIFY(!snapped.summary.leakage_limits());
        QVERIFY2(!notes_of(2).contains("Leakage"), qPrintable(notes_of(2)));
    }

    void text_that_is_no_file_cannot_be_dropped() {
        QMimeData data;
        data.setText("no file");
        QDragEnterEvent enter(QPoint(700, 400), Qt::CopyAction, &data, Qt::LeftButton,
                              Qt::NoModifier);
        enter.ignore();
        QCoreApplication::sendEvent(window_.get(), &enter);
        QVERIFY(!enter.isAccepted());
    }

    void an_opened_file_is_among_the_recent_ones_and_a_bad_one_is_not() {
        openOne("recent.wav");
        document().open({home_.file("bad.wav", "")});
        QVERIFY(QTest::qWaitFor([&] { return !the<MessageBar>().texts().isEmpty(); }));
        const QStringList recent = the<RecentFiles>().paths();
        QCOMPARE(recent.size(), 1);
        QVERIFY(recent.first().endsWith("recent.wav"));
    }

    void a_bad_file_is_told_in_the_window_and_blocks_nothing() {
        document().open({home_.file("words.csv", "only words\nand more words\n")});
        QVERIFY(QTest::qWaitFor([&] { return the<MessageBar>().isVisible(); }));
        QVERIFY(the<MessageBar>().texts().first().contains("words.csv"));
        QVERIFY(!QApplication::activeModalWidget());
        openOne();
    }

    void each_algorithm_can_be_chosen_and_run() {
        openOne();
        auto& algorithms = the<QComboBox>("algorithm");
        QCOMPARE(algorithms.count(), 6);
        for (int index = 0; index < algorithms.count(); ++index) {
            algorithms.setFocus();
            QTest::keyClick(&algorithms, Qt::Key_Home);
            for (int step = 0; step < index; ++step) {
                QTest::keyClick(&algorithms, Qt::Key_Down);
            }
            QTest::mouseClick(&the<QPushButton>("analyse"), Qt::LeftButton);
            // The sixth is what the recording was opened with: it replaces its run.
            QVERIFY(idle(static_cast<std::size_t>(std::min(index + 2, 6))));
            const auto wanted = static_cast<Algorithm>(index);
            QVERIFY(std::ranges::any_of(document().analyses(), [&](const AnalysisEntry& entry) {
                return entry.shown.analysis->settings.algorithm == wanted;
            }));
        }
        QCOMPARE(the<Ledger>().topLevelItemCount(), 6);
    }

    void the_window_is_tied_together_in_samples_periods_and_milliseconds() {
        openOne();
        typeInto(field("Length"), "80");
        const auto in_unit = [this](int unit) -> NumberField& {
            auto& units = the<QComboBox>("lengthUnit");
            units.setFocus();
            QTest::keyClick(&units, Qt::Key_Home);
            for (int step = 0; step < unit; ++step) {
                QTest::keyClick(&units, Qt::Key_Down);
            }
            return field("Length");
        };
        const auto& others = the<QLabel>("otherLengths");
        QCOMPARE(others.text(), QStringLiteral("10 periods · 10 ms"));
        VYBEG_CLOSE(*in_unit(1).value(), 10, 1e-3);
        QCOMPARE(others.text(), QStringLiteral("80 samples · 10 ms"));
        QCOMPARE(*in_unit(2).value(), 10.0);
        typeInto(field("Length"), "5,5");
        QCOMPARE(document().settings().window, 44);
        typeInto(in_unit(1), "7.5");
        QCOMPARE(document().settings().periods, std::optional(7.5));
        QCOMPARE(*in_unit(0).value(), 60.0);
        typeInto(field("Length"), "4");
        QVERIFY(!field("Length").isValid());
        QCOMPARE(document().settings().periods, std::optional(7.5));
    }

    void snap_moves_the_window_to_whole_half_periods() {
        openOne();
        typeInto(field("Length"), "61");
        const QString before = the<QLabel>("residual").text();
        QTest::mouseClick(&the<QPushButton>("snap"), Qt::LeftButton);
        // At 1000 Hz and 8000 Hz half a period is four samples.
        QCOMPARE(document().settings().window % 4, 0);
        VYBEG_WITHIN(document().settings().window, 61, 4);
        QVERIFY(the<QLabel>("residual").text() != before);
    }

    void overlap_and_hop_are_tied_together() {
        openOne();
        typeInto(field("Overlap"), "75");
        QCOMPARE(document().settings().hop, 15);
        typeInto(field("Step"), "30");
        QCOMPARE(*field("Overlap").value(), 50.0);
        QTest::keyClick(&the<TrackView>(), Qt::Key_F5);
        QVERIFY(idle(2));
        QCOMPARE(document().analyses().back().shown.analysis->plan.hop, 30);
    }

    void the_run_key_takes_the_text_of_the_field_being_edited() {
        openOne();
        NumberField& length = field("Length");
        length.setFocus();
        length.selectAll();
        QTest::keyClicks(&length, "88");
        QTest::keyClick(&length, Qt::Key_F5);
        QVERIFY(idle(2));
        QCOMPARE(document().analyses().back().shown.analysis->plan.length, 88);
    }

    void settings_are_undone_and_redone_by_keys() {
        openOne();
        typeInto(field("Length"), "80");
        typeInto(field("Range from"), "0,5");
        window_->action(Command::undo)->trigger();
        QVERIFY(!document().settings().from_s);
        window_->action(Command::undo)->trigger();
        QCOMPARE(*field("Length").value(), 60.0);
        QVERIFY(!window_->action(Command::undo)->isEnabled());
        window_->action(Command::redo)->trigger();
        QCOMPARE(*field("Length").value(), 80.0);
    }

    void the_mouse_over_the_plots_fills_the_table_at_the_cursor() {
        openOne();
        auto& tracks = the<TrackView>();
        auto* plot = tracks.findChild<QCustomPlot*>();
        QTest::mouseMove(plot, QPoint(plot->width() / 2, plot->height() / 2));
        QVERIFY(QTest::qWaitFor([&] { return tracks.tracker().has_value(); }));
        window_->action(Command::copy_table)->trigger();
        const QStringList lines = QApplication::clipboard()->text().split('\n');
        QCOMPARE(lines.size(), 1 + static_cast<int>(shown_slow_variables.size()) + 1);
        QVERIFY(lines.first().startsWith("t = "));
        // a_A = 1 and a_B = 0.1 were simulated with a noise of 1e-3: window of 60, 10 sigma.
        VYBEG_CLOSE(lines.at(1).split('\t').at(1).toDouble(), 1, 2e-3);
        VYBEG_CLOSE(lines.at(2).split('\t').at(1).toDouble(), 0.1, 2e-3);
    }

    void the_plots_are_zoomed_by_wheel_and_history() {
        openOne();
        auto& tracks = the<TrackView>();
        const AxisRange whole = tracks.timeRange();
        const QPointF middle(tracks.width() / 2.0, tracks.height() / 2.0);
        QWheelEvent wheel(middle, tracks.mapToGlobal(middle), {}, QPoint(0, 120), Qt::NoButton,
                          Qt::NoModifier, Qt::NoScrollPhase, false);
        QCoreApplication::sendEvent(&tracks, &wheel);
        VYBEG_LESS(tracks.timeRange().span(), whole.span());
        QVERIFY(window_->action(Command::zoom_back)->isEnabled());
        window_->action(Command::zoom_back)->trigger();
        QCOMPARE(tracks.timeRange(), whole);
    }

    void runs_are_hidden_renamed_and_removed() {
        openOne();
        auto& runs = the<Ledger>();
        QTreeWidgetItem* item = runs.topLevelItem(0);
        item->setCheckState(0, Qt::Unchecked);
        QVERIFY(QTest::qWaitFor([&] { return !document().analyses().front().shown.visible; }));
        QVERIFY(!the<TrackView>().analyses().front().visible);
        runs.topLevelItem(0)->setText(0, "reference");
        QVERIFY(QTest::qWaitFor([&] {
            return document().analyses().front().shown.name == QLatin1String("reference");
        }));
        runs.setFocus();
        QTest::keyClick(&runs, Qt::Key_Delete);
        QVERIFY(document().analyses().empty());
        QVERIFY(!window_->action(Command::export_plots)->isEnabled());
    }

    void plots_are_exported_by_the_ending_of_the_name() {
        openOne();
        for (const char* name : {"plots.png", "plots.svg", "plots.pdf"}) {
            QVERIFY(exportPlotsTo(*window_, home_.path(name)));
        }
        QVERIFY(!QImage(home_.path("plots.png")).isNull());
        QFile pdf(home_.path("plots.pdf"));
        QVERIFY(pdf.open(QIODevice::ReadOnly) && pdf.read(5) == "%PDF-");
        QFile svg(home_.path("plots.svg"));
        QVERIFY(svg.open(QIODevice::ReadOnly) && svg.read(200).contains("<svg"));
        QVERIFY(!exportPlotsTo(*window_, home_.path("no/such/folder/plots.png")));
        QVERIFY(the<MessageBar>().texts().first().contains("cannot be written"));
    }

    void a_second_longer_recording_is_shown_whole() {
        openOne();
        auto& tracks = the<TrackView>();
        tracks.setTimeRange({0.5, 1.0});
        document().open({home_.recording("longer.wav", 6)});
        QVERIFY(idle(2));
        QCOMPARE(tracks.timeRange(), tracks.fullTimeRange());
        VYBEG_MORE(tracks.timeRange().upper, 5.9);
        QCOMPARE(the<SignalView>().visibleRange(), tracks.timeRange());
        window_->action(Command::zoom_back)->trigger();
        QCOMPARE(tracks.timeRange(), (AxisRange{0.5, 1.0}));
    }

    void overview_and_plots_have_one_range_where_a_part_is_analysed() {
        openOne();
        typeInto(field("Range from"), "1");
        window_->action(Command::analyse)->trigger();
        QVERIFY(idle(2));
        document().removeAnalysis(document().analyses().front().shown.id);
        auto& overview = the<SignalView>();
        auto& tracks = the<TrackView>();
        QCOMPARE(overview.visibleRange(), tracks.timeRange());
        // Its left edge, to where nothing is analysed.
        const int middle = overview.height() / 3;
        const QPoint edge(qRound(overview.width() * 0.5), middle);
        for (const QPoint& start : {edge, edge + QPoint(3, 0), edge - QPoint(3, 0)}) {
            QTest::mousePress(&overview, Qt::LeftButton, {}, start);
            QTest::mouseMove(&overview, QPoint(overview.width() / 4, middle));
            QTest::mouseRelease(&overview, Qt::LeftButton, {},
                                QPoint(overview.width() / 4, middle));
            QCOMPARE(overview.visibleRange(), tracks.timeRange());
        }
    }

    void the_runs_icons_follow_the_theme() {
        openOne();
        window_->setThemeMode(ThemeMode::light);
        const auto ground = [this] {
            return the<Ledger>().topLevelItem(0)->icon(0).pixmap(28, 14).toImage().pixelColor(1, 1);
        };
        QCOMPARE(ground(), lightTheme().palette.color(QPalette::Base));
        window_->setThemeMode(ThemeMode::dark);
        QTRY_COMPARE(ground(), darkTheme().palette.color(QPalette::Base));
        window_->setThemeMode(ThemeMode::light);
    }

    void the_track_is_exported_with_its_header_in_the_background() {
        openOne();
        window_->files().exportTrackTo(home_.path("track.csv"));
        QVERIFY(QTest::qWaitFor([&] { return QFile::exists(home_.path("track.csv")); }));
        QFile csv(home_.path("track.csv"));
        QVERIFY(csv.open(QIODevice::ReadOnly));
        const QList<QByteArray> lines = csv.readAll().trimmed().split('\n');
        const auto header = std::ranges::count_if(
            lines, [](const QByteArray& line) { return line.startsWith("# "); });
        VYBEG_MORE(header, 10);
        QVERIFY(lines.at(header).startsWith("t_s,a_A,a_B,two_theta_A_rad"));
        QCOMPARE(lines.size() - header - 1, qsizetype(16000 / 60));
    }

    // A column for each analysis that is shown, with its scatter, exported as other plots are.
    void the_articles_figure_compares_the_analyses() {
        openOne();
        for (const int length : {8, 160}) {
            Settings settings = document().settings();
            settings.window = length;
            document().setSettings(settings);
            document().analyse();
            QTRY_VERIFY(!document().busy());
        }
        QVERIFY(idle(3));
        const auto width = [this] {
            window_->action(Command::article_figure)->trigger();
            auto& dialog = the<ExportDialog>();
            const Figure figure = dialog.figure();
            const bool written =
                bool(writeDrawing(figure.draw, {figure.size}, home_.path("figure.svg")));
            dialog.reject();
            QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
            return written ? figure.size.width() : 0;
        };
        const int three = width();
        QVERIFY(three > 0);
        QFile svg(home_.path("figure.svg"));
        QVERIFY(svg.open(QIODevice::ReadOnly));
        VYBEG_MORE(svg.size(), 1000);
        document().setAnalysisVisible(document().analyses().front().shown.id, false);
        QTRY_VERIFY(!the<TrackView>().analyses().front().visible);
        QCOMPARE(width(), three * 2 / 3);
        QVERIFY(window_->action(Command::article_figure)->shortcut() == QKeySequence(Qt::Key_F6));
    }

    void an_event_takes_the_plots_there() {
        openOne();
        window_->action(Command::zoom_in)->trigger();
        emit the<FindingsFlag>().placeChosen(1.5, 0);
        QVERIFY(the<TrackView>().timeRange().contains(1.5));
        QCOMPARE(the<TrackView>().tracker(), std::optional(1.5));
    }

    void help_follows_the_language() {
        window_->action(Command::help)->trigger();
        const auto& browser = the<HelpView>().browser();
        QVERIFY(browser.source().toString().contains("/help/en/"));
        VYBEG_MORE(browser.toPlainText().size(), 200);
        window_->setLanguage("ru");
        QVERIFY(browser.source().toString().contains("/help/ru/"));
    }

    void the_help_finds_a_text_on_any_page() {
        window_->action(Command::help)->trigger();
        const auto& help = the<HelpView>();
        auto* wanted = help.findChild<QLineEdit*>();
        const auto find = [&](const char* text) {
            wanted->setText(text);
            QTest::keyClick(wanted, Qt::Key_Return);
            return help.browser().textCursor().selectedText();
        };
        QCOMPARE(find("LGraph2"), QString("LGraph2"));
        const QString page = help.browser().source().fileName();
        QVERIFY(page != "index.html");
        QCOMPARE(find("LGraph2"), QString("LGraph2"));  // the next, or the first again
        QCOMPARE(find("Cramér"), QString("Cramér"));
        find("no such words anywhere");
        QVERIFY(QToolTip::text().contains("No page has “no such words anywhere”."));
    }

    void theme_and_language_are_kept_for_the_next_session() {
        window_->setLanguage("ru");
        window_->setThemeMode(ThemeMode::dark);
        window_->close();
        window_ = std::make_unique<TestWindow>();
        QVERIFY(window_->diagnosticsText().contains("Language ru, theme dark"));
        QVERIFY(window_->diagnosticsText().contains("Recordings: 0, analyses: 0"));
        window_->setThemeMode(ThemeMode::light);
    }
};

VYBEG_TEST(TestMainWindow, threads)

}  // namespace test_main_window

#include "test_main_window.moc"
