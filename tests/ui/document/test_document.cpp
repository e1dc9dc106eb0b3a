#include "tests/closeness.h"
#include "tests/test_registry.h"
#include "tests/ui/gui_home.h"
#include "ui/document/document.h"
#include "ui/words/error_text.h"

#include <QElapsedTimer>
#include <QSignalSpy>
#include <QTest>

#include <algorithm>
#include <cmath>

namespace test_document {

using namespace vybeg;
using namespace vybeg::ui;

class TestDocument : public QObject {
    Q_OBJECT

    GuiTestHome home_;

    static bool idle(const Document& document, std::size_t runs) {
        return QTest::qWaitFor(
            [&] { return !document.busy() && document.analyses().size() == runs; }, 20000);
    }

private slots:
    void an_opened_recording_is_analysed_hashed_and_drawn_without_being_asked() {
        Document document;
        document.open({home_.recording("one.wav")});
        QVERIFY(idle(document, 1));
        const AnalysisEntry& entry = document.analyses().front();
        QCOMPARE(entry.shown.analysis->plan.length, 60);
        QCOMPARE(entry.summary.windows, std::size_t(16000 / 60));
        // Five standard errors of the mean, and its error itself below 1 ppm.
        VYBEG_CLOSE(entry.summary.mean_f_hz, 1000, 5 * entry.summary.sd_mean_f_hz + 1e-9);
        VYBEG_LESS(entry.summary.sd_mean_f_hz, 1e-2);
        VYBEG_MORE(entry.shown.analysis->timing.estimate_s, 0);
        QVERIFY(QTest::qWaitFor([&] {
            const RecordingEntry* current = document.currentRecording();
            return current->envelope && current->sha256.size() == 64 && current->f0_hz;
        }));
        VYBEG_CLOSE(*document.currentRecording()->f0_hz, 1000, 0.01);
    }

    void the_recording_check_finds_lost_samples_and_flags_their_windows() {
        QByteArray text = "# fs = 8000 Hz\nC,D\n";
        for (int j = 0; j < 16000; ++j) {
            if (j != 8000) {
                const double x = std::cos(0.8 * j + 1);
                const double noise = 1e-3 * std::sin(1.7 * j * j);
                text += QByteArray::number(0.9 * x + noise) + ',' +
                        QByteArray::number(0.4 * x - noise) + '\n';
            }
        }
        Document document;
        QStringList messages;
        connect(&document, &Document::reported, this,
                [&](const Message& message) { messages << message.text(); });
        const OpenOptions options{.rate_hz = 8000};
        document.open({home_.file("lost.csv", text)}, options);
        QVERIFY(idle(document, 1));
        const auto checked = [&] { return document.currentRecording()->faults != nullptr; };
        QVERIFY(QTest::qWaitFor(checked));
        const SampleFaults& faults = *document.currentRecording()->faults;
        QCOMPARE(faults.steps.size(), std::size_t(1));
        VYBEG_WITHIN(faults.steps[0].frame, 8000, 1);
        QCOMPARE(messages.filter("lost.csv: Samples lost: 1 at ").size(), 1);
        const auto gaps = [&] {
            return std::ranges::count_if(document.analyses().back().shown.analysis->track.flags(),
                                         [](Flags flags) { return has(flags, Flag::gap); });
        };
        QCOMPARE(gaps(), 1);
        QVERIFY(std::ranges::all_of(document.analyses().back().events,
                                    [](const Event& e) { return e.flag == Flag::gap; }));
        QCOMPARE(document.analyses().back().events.size(), std::size_t(1));
    }

    void several_recordings_are_open_at_once_and_each_has_its_run() {
        Document document;
        document.open(
            {home_.recording("a.wav"), home_.recording("b.csv"), home_.recording("c.wav")});
        QVERIFY(idle(document, 3));
        QCOMPARE(document.recordings().size(), std::size_t(3));
        QSet<QRgb> looks;
        for (const AnalysisEntry& entry : document.analyses()) {
            looks.insert(entry.shown.color.rgb() ^ static_cast<QRgb>(entry.shown.shade));
        }
        QCOMPARE(looks.size(), 3);
        document.closeRecording(document.recordings().front().id);
        QCOMPARE(document.recordings().size(), std::size_t(2));
        QCOMPARE(document.analyses().size(), std::size_t(2));
    }

    void a_bad_file_leaves_a_message_and_nothing_else_data() {
        QTest::addColumn<QString>("path");
        QTest::addColumn<bool>("can_be_reopened");
        QTest::newRow("missing") << home_.path("missing.wav") << false;
        QTest::newRow("empty") << home_.file("empty.wav", "") << false;
        QTest::newRow("folder") << home_.path(".") << false;
        QTest::newRow("text") << home_.file("words.csv", "these are\nonly words\n") << false;
        QTest::newRow("no rate") << home_.file("norate.csv", "1 2\n3 4\n5 6\n7 8\n9 1\n1 2\n")
                                 << true;
    }
    void a_bad_file_leaves_a_message_and_nothing_else() {
        QFETCH(QString, path);
        QFETCH(bool, can_be_reopened);
        Document document;
        Message last;
        int messages = 0;
        connect(&document, &Document::reported, this, [&](const Message& message) {
            last = message;
            ++messages;
        });
        document.open({path});
        QVERIFY(QTest::qWaitFor([&] { return messages > 0; }));
        QCOMPARE(messages, 1);
        QCOMPARE(last.severity, MessageLevel::error);
        QVERIFY(!last.text().isEmpty());
        QCOMPARE(!last.buttons.empty(), can_be_reopened);
        QVERIFY(document.recordings().empty());
        QVERIFY(document.analyses().empty());
    }

    void a_new_run_of_a_recording_replaces_the_one_that_still_computes() {
        Document document;
        document.open({home_.recording("stale.wav", 60)});
        QVERIFY(QTest::qWaitFor([&] { return document.busy(); }));
        // Asked for in one go: only the last may leave a run.
        for (const std::int64_t window : {6, 7, 8, 9, 48}) {
            Settings settings = document.settings();
            settings.window = window;
            settings.algorithm = Algorithm::conjugate_gradient;
            document.setSettings(settings);
            document.analyse();
        }
        QVERIFY(idle(document, 1));
        QCOMPARE(document.analyses().front().shown.analysis->plan.length, 48);
        // Analyses compute one after the other: the stale ones have ended before the last began.
        deliverPosted();
        QCOMPARE(document.analyses().size(), std::size_t(1));
    }

    void cancel_stops_at_once_and_leaves_the_runs_as_they_were() {
        Document document;
        document.open({home_.recording("cancel.wav", 120)});
        QVERIFY(idle(document, 1));
        Settings settings = document.settings();
        settings.algorithm = Algorithm::conjugate_gradient;
        settings.window = 600;
        settings.hop = 1;
        document.setSettings(settings);
        QSignalSpy messages(&document, &Document::reported);
        document.analyse();
        QVERIFY(QTest::qWaitFor([&] { return document.progress() > 0; }, 20000));
        QVERIFY2(document.busy(), "the analysis must be long enough to be cancelled");
        VYBEG_LESS(document.progress(), 1);
        QElapsedTimer clock;
        clock.start();
        document.cancel();
        QVERIFY(idle(document, 1));
        // The analysis would take minutes; a tenth of a second is usual, more where the machine is
        // busy.
        VYBEG_LESS(clock.elapsed(), 5000);
        QCOMPARE(messages.count(), 0);
    }

    void a_document_that_goes_away_stops_its_work() {
        auto document = std::make_unique<Document>();
        document->open({home_.recording("away.wav", 120)});
        QVERIFY(idle(*document, 1));
        Settings settings = document->settings();
        settings.algorithm = Algorithm::conjugate_gradient;
        settings.window = 600;
        settings.hop = 1;
        document->setSettings(settings);
        document->analyse();
        QVERIFY(QTest::qWaitFor([&] { return document->progress() > 0; }, 20000));
        QElapsedTimer clock;
        clock.start();
        document.reset();
        VYBEG_LESS(clock.elapsed(), 5000);
    }

    void the_same_settings_again_replace_their_run_and_keep_its_name() {
        Document document;
        document.open({home_.recording("same.wav")});
        QVERIFY(idle(document, 1));
        const auto id = document.analyses().front().shown.id;
        document.renameAnalysis(id, "mine");
        document.analyse();
        QVERIFY(idle(document, 1));
        QCOMPARE(document.analyses().front().shown.id, id);
        QCOMPARE(document.analyses().front().shown.name, QStringLiteral("mine"));
    }

    void rerun_brings_the_settings_of_a_run_back() {
        Document document;
        document.open({home_.recording("analyseAgain.wav")});
        QVERIFY(idle(document, 1));
        const auto first = document.analyses().front().shown.id;
        Settings settings = document.settings();
        settings.window = 80;
        settings.algorithm = Algorithm::demodulation;
        document.setSettings(settings);
        document.analyse();
        QVERIFY(idle(document, 2));
        document.analyseAgain(first);
        QVERIFY(idle(document, 2));
        QCOMPARE(document.settings().window, 60);
        QCOMPARE(document.settings().algorithm, Algorithm::maximum_likelihood);
    }

    void settings_are_undone_and_redone_and_a_drag_is_one_step() {
        Document document;
        Settings settings = document.settings();
        settings.window = 44;
        document.setSettings(settings);
        for (const double from : {0.1, 0.2, 0.3}) {
            settings.from_s = from;
            document.setSettings(settings, 7);
        }
        document.setSettings(settings);  // no change, no step
        QCOMPARE(document.undoStack().count(), 2);
        document.undoStack().undo();
        QVERIFY(!document.settings().from_s);
        QCOMPARE(document.settings().window, 44);
        document.undoStack().undo();
        QCOMPARE(document.settings(), Settings{});
        document.undoStack().redo();
        document.undoStack().redo();
        QCOMPARE(document.settings().from_s, std::optional(0.3));
    }

    void an_impossible_setting_is_told_and_leaves_no_run() {
        Document document;
        document.open({home_.recording("impossible.wav")});
        QVERIFY(idle(document, 1));
        QSignalSpy messages(&document, &Document::reported);
        Settings settings = document.settings();
        settings.window = 1000000;
        document.setSettings(settings);
        document.analyse();
        QVERIFY(messages.wait(20000));
        QVERIFY(idle(document, 1));
    }

    // A defect of the program reaches whoever waits for the result; the program goes on.
    void a_fault_in_a_worker_is_an_error_of_its_job() {
        BackgroundJobs jobs;
        std::optional<Result<int>> faulty;
        std::optional<Result<int>> sound;
        jobs.run<int>(
            1, [](const JobControl&) -> Result<int> { return std::vector<int>().at(3); },
            [&](Result<int> result) { faulty = std::move(result); });
        QVERIFY(QTest::qWaitFor([&] { return faulty.has_value(); }));
        QVERIFY(!*faulty);
        QCOMPARE(faulty->error().code, ErrorCode::program_fault);
        // The sentence holds it: it stood there empty.
        QVERIFY2(errorText(faulty->error()).contains("(std::out_of_range: vector::_M_range_check"),
                 qPrintable(errorText(faulty->error())));
        jobs.run<int>(
            1, [](const JobControl&) -> Result<int> { return 7; },
            [&](Result<int> result) { sound = std::move(result); });
        QVERIFY(QTest::qWaitFor([&] { return sound.has_value(); }));
        QVERIFY(*sound);
        QCOMPARE(**sound, 7);
    }
};

VYBEG_TEST(TestDocument, threads)

}  // namespace test_document

#include "test_document.moc"
