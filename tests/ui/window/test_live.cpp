// Live analysis: a run that follows the settings.
#include "tests/closeness.h"
#include "tests/test_registry.h"
#include "tests/ui/gui_test.h"
#include "ui/panels/ledger.h"
#include "ui/panels/message_bar.h"
#include "ui/plots/track_view.h"
#include "ui/window/status_line.h"

#include <QCheckBox>
#include <QPushButton>
#include <QTest>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <map>
#include <set>

namespace test_live {

using namespace vybeg;
using namespace vybeg::ui;

namespace {

// What a document showed of its live run each time that it changed.
struct Shown {
    std::int64_t length = 0;
    std::shared_ptr<const Analysis> analysis;
    bool partial = false;
};

std::size_t rows_between(const Track& track, const TimeRange& range) {
    return static_cast<std::size_t>(std::ranges::count_if(
        track.time_s(), [&](double t) { return t >= range.from_s && t <= range.to_s; }));
}

}  // namespace

class TestLive : public QObject {
    Q_OBJECT

    GuiTestHome home_;
    QString short_;
    QString long_;  // with one sample of hop it takes long enough to be shown early

    static bool idle(const Document& document, std::size_t runs) {
        return QTest::qWaitFor(
            [&] { return !document.busy() && document.analyses().size() == runs; }, 60000);
    }

    using History = std::shared_ptr<std::vector<Shown>>;
    static History watch(Document& document) {
        auto shown = std::make_shared<std::vector<Shown>>();
        connect(&document, &Document::analysesChanged, &document, [&document, shown] {
            for (const AnalysisEntry& entry : document.analyses()) {
                const auto& analysis = entry.shown.analysis;
                if (entry.live && (shown->empty() || shown->back().analysis != analysis)) {
                    shown->push_back({analysis->plan.length, analysis, entry.partial()});
                }
            }
        });
        return shown;
    }

    static void change(Document& document, std::int64_t window, std::int64_t hop = 0) {
        Settings settings = document.settings();
        settings.window = window;
        settings.hop = hop;
        document.setSettings(settings);
    }

    // Takes long enough to be stopped.
    static void makeSlow(Document& document) {
        Settings settings = document.settings();
        settings.algorithm = Algorithm::conjugate_gradient;
        settings.hop = 1;
        document.setSettings(settings);
    }

private slots:
    void initTestCase() {
        short_ = home_.recording("short.wav");
        long_ = home_.recording("long.wav", 120);
    }

    void a_change_updates_the_run_in_its_place() {
        Document document;
        document.setLive(true);
        document.open({short_});
        QVERIFY(idle(document, 1));
        const AnalysisEntry before = document.analyses().front();
        QVERIFY(before.live);
        QCOMPARE(before.shown.name, QStringLiteral("short"));
        change(document, 80);
        QVERIFY(idle(document, 1));
        const AnalysisEntry& after = document.analyses().front();
        QCOMPARE(after.shown.analysis->plan.length, 80);
        QCOMPARE(after.shown.id, before.shown.id);
        QCOMPARE(after.shown.name, before.shown.name);
        QCOMPARE(after.shown.color, before.shown.color);
        QCOMPARE(after.shown.shade, before.shown.shade);
        Settings settings = document.settings();
        settings.algorithm = Algorithm::demodulation;
        settings.calibration.kappa = 1.5;
        document.setSettings(settings);
        QVERIFY(idle(document, 1));
        QCOMPARE(document.analyses().front().shown.analysis->settings.calibration.kappa, 1.5);
        QCOMPARE(document.analyses().front().shown.analysis->settings.algorithm,
                 Algorithm::demodulation);
    }

    void runs_stand_and_are_coloured_as_their_recordings_whichever_is_done_first() {
        for (const QStringList& files : {QStringList{long_, short_}, QStringList{short_, long_}}) {
            Document document;
            document.setLive(true);
            change(document, 60, 1);
            document.open(files);
            QVERIFY(idle(document, 2));
            for (std::size_t k = 0; k < 2; ++k) {
                const AnalysisEntry& entry = document.analyses()[k];
                QCOMPARE(entry.recording_id, document.recordings()[k].id);
                QCOMPARE(entry.shown.color, curveStyle(static_cast<int>(k)).color);
                QCOMPARE(entry.shown.shade, 0);
            }
        }
    }

    void analyses_of_a_recording_are_shades_of_its_colour() {
        Document document;
        document.setLive(false);
        document.open({short_, long_});
        QVERIFY(idle(document, 2));
        for (const std::size_t more : {1, 2}) {
            change(document, 70 + 10 * static_cast<int>(more));
            document.analyse();
            QVERIFY(idle(document, 2 + more));
        }
        std::map<QRgb, std::set<int>> shades;
        std::map<QRgb, std::set<int>> recordings;
        for (const AnalysisEntry& entry : document.analyses()) {
            shades[entry.shown.color.rgb()].insert(entry.shown.shade);
            recordings[entry.shown.color.rgb()].insert(number(entry.recording_id));
        }
        QCOMPARE(shades.size(), std::size_t(2));
        for (const auto& [color, of] : recordings) {
            QCOMPARE(of.size(), std::size_t(1));
            const auto count = std::ranges::count_if(
                document.analyses(),
                [rgb = color](const AnalysisEntry& e) { return e.shown.color.rgb() == rgb; });
            QCOMPARE(std::ptrdiff_t(shades[color].size()), count);
        }
    }

    void the_live_run_is_not_removed_while_live_is_on() {
        const auto window = shownWindow();
        Document& document = window->document();
        document.setLive(true);
        document.open({short_});
        QTRY_VERIFY(!document.busy() && document.analyses().size() == 1);
        auto& list = childOf<Ledger>(*window);
        list.setFocus();
        QTest::keyClick(&list, Qt::Key_Delete);
        deliverPosted();
        QCOMPARE(document.analyses().size(), std::size_t(1));
        document.setLive(false);
        QTest::keyClick(&list, Qt::Key_Delete);
        QTRY_VERIFY(document.analyses().empty());
    }

    void run_keeps_what_the_live_run_leaves() {
        Document document;
        document.setLive(true);
        document.open({short_});
        QVERIFY(idle(document, 1));
        document.analyse();
        QVERIFY(idle(document, 2));
        document.analyse();  // the same once more: the same run
        QVERIFY(idle(document, 2));
        change(document, 80);
        QVERIFY(idle(document, 2));
        QCOMPARE(document.analyses()[0].shown.analysis->plan.length, 80);
        QCOMPARE(document.analyses()[1].shown.analysis->plan.length, 60);
        QVERIFY(!document.analyses()[1].live);
        QCOMPARE(document.plottedAnalyses().back().id, document.analyses()[0].shown.id);  // on top
        QCOMPARE(document.analyses()[1].shown.color, document.analyses()[0].shown.color);
        QVERIFY(document.analyses()[1].shown.shade != document.analyses()[0].shown.shade);
    }

    void the_visible_part_arrives_first_and_is_that_of_the_whole() {
        Document document;
        document.setLive(true);
        document.open({long_});
        QVERIFY(idle(document, 1));
        const TimeRange visible{30, 31};
        document.setVisibleRange(visible);
        const History history = watch(document);
        const std::vector<Shown>& shown = *history;
        change(document, 64, 1);
        QVERIFY(idle(document, 1));
        QCOMPARE(shown.size(), std::size_t(2));
        QVERIFY(shown[0].partial && !shown[1].partial);
        const Track& part = shown[0].analysis->track;
        const Track& whole = shown[1].analysis->track;
        VYBEG_MORE(rows_between(part, visible), 7900);
        QCOMPARE(rows_between(part, visible), rows_between(whole, visible));
        // The curve of other settings is nowhere shown as if it were this one.
        QCOMPARE(part.time_s().front(), whole.time_s().front());
        QCOMPARE(part.time_s().back(), whole.time_s().back());
        std::size_t row = 0;
        for (std::size_t k = 0; k < part.rows(); ++k) {
            while (whole.time_s()[row] < part.time_s()[k] - 1e-9) {
                ++row;
            }
            for (const SlowVariable variable : all_slow_variables) {
                const double expected = whole.values(variable)[row];
                VYBEG_WITHIN(part.values(variable)[k], expected,
                             1e-9 * std::max(1.0, std::abs(expected)));
            }
        }
        QVERIFY(document.analyses().front().events.empty());
    }

    void the_newest_of_many_settings_wins_and_none_is_shown_late() {
        Document document;
        document.setLive(true);
        document.open({long_});
        QVERIFY(idle(document, 1));
        const History history = watch(document);
        const std::vector<Shown>& shown = *history;
        // A spin box that is held, while the first of them computes already.
        std::clock_t begin = std::clock();
        for (std::int64_t window = 40; window <= 140; ++window) {
            change(document, window, 1);
            QTest::qWait(2);  // the pace of the spin box, in which nothing is waited for
        }
        QVERIFY(idle(document, 1));
        const std::clock_t all = std::clock() - begin;
        QCOMPARE(shown.back().length, 140);
        QVERIFY(!shown.back().partial);
        // In the order of asking: nothing stale comes later.
        QVERIFY(std::ranges::is_sorted(shown, {}, &Shown::length));
        QCOMPARE(std::ranges::count_if(shown, [](const Shown& s) { return !s.partial; }), 1);
        // A hundred runs in a queue would take a hundred times the processor time of one.
        begin = std::clock();
        change(document, 141, 1);
        QVERIFY(idle(document, 1));
        const std::clock_t one = std::clock() - begin;
        VYBEG_LESS(all, 3 * CLOCKS_PER_SEC / 2 + 15 * one,
                   qPrintable(QString("%1 s, one %2 s")
                                  .arg(double(all) / CLOCKS_PER_SEC)
                                  .arg(double(one) / CLOCKS_PER_SEC)));
    }

    void undo_and_redo_are_followed() {
        Document document;
        document.setLive(true);
        document.open({short_});
        QVERIFY(idle(document, 1));
        change(document, 80);
        QVERIFY(idle(document, 1));
        document.undoStack().undo();
        QVERIFY(idle(document, 1));
        QCOMPARE(document.analyses().front().shown.analysis->plan.length, 60);
        document.undoStack().redo();
        QVERIFY(idle(document, 1));
        QCOMPARE(document.analyses().front().shown.analysis->plan.length, 80);
    }

    void nothing_is_run_while_live_is_off() {
        Document document;
        document.open({short_});
        QVERIFY(idle(document, 1));
        change(document, 80);
        QVERIFY(!document.busy());
        deliverPosted();
        QVERIFY(!document.busy());
        QCOMPARE(document.analyses().front().shown.analysis->plan.length, 60);
        // Switched on, it catches up, and leaves what was there.
        document.setLive(true);
        QVERIFY(idle(document, 2));
        QCOMPARE(document.analyses()[0].shown.analysis->plan.length, 60);
        QCOMPARE(document.analyses()[1].shown.analysis->plan.length, 80);
        document.setLive(false);
        change(document, 44);
        QVERIFY(!document.busy());
    }

    void only_the_current_recording_follows() {
        Document document;
        document.setLive(true);
        document.open({short_, home_.recording("other.wav")});
        QVERIFY(idle(document, 2));
        const auto first = document.analyses()[0].recording_id;
        const auto second = document.analyses()[1].recording_id;
        document.setCurrentRecording(first);
        QVERIFY2(!document.busy(), "it shows the settings already");
        change(document, 80);
        QVERIFY(idle(document, 2));
        const auto length_of = [&](RecordingId recording) {
            const auto entry =
                std::ranges::find(document.analyses(), recording, &AnalysisEntry::recording_id);
            return entry->shown.analysis->plan.length;
        };
        QCOMPARE(length_of(first), 80);
        QCOMPARE(length_of(second), 60);
        document.setCurrentRecording(second);
        QVERIFY(idle(document, 2));
        QCOMPARE(length_of(second), 80);
    }

    void the_known_carrier_gives_what_the_search_gives() {
        Document document;
        document.setLive(true);
        document.open({short_});
        QVERIFY(idle(document, 1));
        Settings settings = document.settings();
        settings.calibration.offset_auto = true;
        settings.from_s = 0.5;
        document.setSettings(settings);
        QVERIFY(idle(document, 1));
        settings.window = 44;
        document.setSettings(settings);
        QVERIFY(idle(document, 1));
        const Recording& recording = *document.currentRecording()->recording;
        const auto plain = analyse(recording, settings, {});
        QVERIFY(plain);
        const Analysis& live = *document.analyses().front().shown.analysis;
        QCOMPARE(live.settings, plain->settings);
        for (const SlowVariable variable : all_slow_variables) {
            QVERIFY(std::ranges::equal(live.track.values(variable), plain->track.values(variable)));
        }
        QCOMPARE(*document.carrier(), plain->f0_hz());
    }

    void a_removed_live_run_stays_away_until_the_next_change() {
        Document document;
        document.setLive(true);
        document.open({long_});
        QVERIFY(idle(document, 1));
        change(document, 64, 1);
        document.removeAnalysis(document.analyses().front().shown.id);
        QVERIFY(idle(document, 0));
        const History history = watch(document);
        deliverPosted();
        QCOMPARE(document.analyses().size(), std::size_t(0));
        // Live runs compute one after the other: by the end of this one the removed one has ended.
        change(document, 80);
        QVERIFY(idle(document, 1));
        QVERIFY(std::ranges::none_of(*history, [](const Shown& s) { return s.length == 64; }));
    }

    void a_cancelled_live_run_is_known_as_partial_and_not_written() {
        Document document;
        document.setLive(true);
        document.open({long_});
        QVERIFY(idle(document, 1));
        makeSlow(document);
        QVERIFY(QTest::qWaitFor([&] { return document.analyses().front().partial(); }, 20000));
        document.cancel();
        QVERIFY(idle(document, 1));
        QVERIFY(document.analyses().front().partial());
        bool told = false;
        document.exportTrack(document.analyses().front().shown.id, home_.path("partial.csv"),
                             [&](const Status&) { told = true; });
        QVERIFY(!document.busy());
        deliverPosted();
        QVERIFY(!told && !QFile::exists(home_.path("partial.csv")));
    }

    void the_window_follows_keeps_its_zoom_and_tells_one_error() {
        const auto window = shownWindow();
        window->action(Command::live)->setChecked(false);
        window->action(Command::live)->trigger();
        Document& document = window->document();
        QVERIFY(document.live());
        document.open({short_});
        QVERIFY(idle(document, 1));
        auto& tracks = *window->findChild<TrackView*>();
        auto& messages = *window->findChild<MessageBar*>();
        auto& list = *window->findChild<Ledger*>();
        tracks.setTimeRange({0.5, 1.0});
        tracks.setCursor(Cursor::a, 0.7);
        NumberField& length = fieldOf(*window, "Length");
        length.setFocus();
        QTest::keyClick(&length, Qt::Key_Up);
        QTest::keyClick(&length, Qt::Key_Up);
        QVERIFY(idle(document, 1));
        QCOMPARE(document.analyses().front().shown.analysis->plan.length, 62);
        QCOMPARE(tracks.timeRange(), (AxisRange{0.5, 1.0}));
        QCOMPARE(tracks.cursor(Cursor::a), std::optional(0.7));
        QCOMPARE(list.topLevelItemCount(), 1);
        QVERIFY(list.topLevelItem(0)->font(0).italic());

        const auto type = [&](const char* text) {
            typeInto(length, text);
            QVERIFY(QTest::qWaitFor([&] { return !document.busy(); }, 20000));
        };
        // Impossible ones, each with other numbers: one message, the newest.
        for (const char* text : {"100000", "200000", "300000"}) {
            type(text);
            QCOMPARE(messages.texts().size(), 1);
        }
        QVERIFY(messages.texts().first().contains("300"));
        QCOMPARE(document.analyses().front().shown.analysis->plan.length, 62);
        type("70");
        QVERIFY(messages.texts().isEmpty());
        QCOMPARE(document.analyses().front().shown.analysis->plan.length, 70);
    }

    void cancelling_ends_what_the_status_bar_says() {
        const auto window = shownWindow();
        Document& document = window->document();
        document.open({long_});
        QVERIFY(idle(document, 1));
        makeSlow(document);
        document.analyse();
        const auto& status = childOf<StatusLine>(*window);
        QVERIFY(QTest::qWaitFor([&] { return status.text() == QStringLiteral("Analysing…"); }));
        QTest::mouseClick(&childOf<QPushButton>(*window, "cancel"), Qt::LeftButton);
        QVERIFY(QTest::qWaitFor([&] { return !document.busy(); }, 20000));
        QCOMPARE(status.text(), QStringLiteral("Cancelled"));
        QVERIFY(!childOf<QPushButton>(*window, "cancel").isVisible());
    }

    void the_switch_is_in_panel_and_menu_and_remembered() {
        auto window = shownWindow();
        auto* box = window->findChild<QCheckBox*>("live");
        QVERIFY(box);
        box->click();
        const bool now = window->document().live();
        QCOMPARE(box->isChecked(), now);
        QCOMPARE(window->action(Command::live)->isChecked(), now);
        window->action(Command::live)->trigger();
        QCOMPARE(box->isChecked(), !now);
        box->click();
        window->close();
        window = std::make_unique<TestWindow>();
        QCOMPARE(window->document().live(), now);
        QCOMPARE(window->action(Command::live)->isChecked(), now);
        QSettings().clear();
        window = std::make_unique<TestWindow>();
        QVERIFY2(window->document().live(), "by default");
    }
};

VYBEG_TEST(TestLive, threads)

}  // namespace test_live

#include "test_live.moc"
