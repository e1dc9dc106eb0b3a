// The tree of the sets: built by dropping, edited by keyboard, named and removed.
#include "tests/test_registry.h"
#include "tests/ui/gui_test.h"
#include "tests/ui/resonator_runs.h"
#include "ui/charts/round_plot.h"
#include "ui/panels/ledger.h"
#include "ui/plots/plot_view.h"
#include "ui/resonator/set_panel.h"
#include "ui/window/file_commands.h"

#include <QLineEdit>
#include <QTest>

namespace test_set_tree {

using namespace vybeg;
using namespace vybeg::ui;

class TestSetTree : public QObject, private WindowTest {
    Q_OBJECT

    QStringList files_;

    SetStore& setStore() { return document().sets(); }

private slots:
    void initTestCase() { files_ = resonatorRuns(home_, "run"); }
    void init() { window_ = shownWindow(); }
    void cleanup() { window_.reset(); }

    void a_set_is_built_by_dropping_recordings_and_files() {
        openRuns({files_[0], files_[1]});
        setStore().addToCurrent(ids());
        QCOMPARE(setStore().current()->recordings, ids());
        setStore().addToCurrent(ids());  // once more changes nothing
        QCOMPARE(the<SetTree>("sets").members().size(), std::size_t(2));
        QVERIFY(dropFiles(*the<SetTree>("sets").viewport(), {files_[1], files_[2]}));
        QTRY_VERIFY_WITH_TIMEOUT(document().recordings().size() == 3 && allOpen(), 20000);
        QCOMPARE(setStore().current()->recordings, ids());
        QCOMPARE(the<SetTree>("sets").members().size(), std::size_t(3));
        QVERIFY(setStore().canIdentify());
        // The list follows the current recording with one row, however many were dragged.
        QCOMPARE(the<Ledger>().selectedRecordings(),
                 std::vector<RecordingId>{document().currentRecording()->id});
    }

    void a_set_is_edited_by_keyboard() {
        openRuns(files_);
        window_->action(Command::page_tracks)->trigger();
        auto& list = the<Ledger>();
        list.setFocus();
        list.selectAll();
        QTest::keyClick(&list, Qt::Key_Insert);
        QCOMPARE(setStore().current()->recordings, ids());
        window_->action(Command::page_resonator)->trigger();
        auto& sets = the<SetTree>("sets");
        sets.setFocus();
        sets.setCurrentItem(sets.members()[1]);
        QTest::keyClick(&sets, Qt::Key_Space);
        QTRY_COMPARE(setStore().current()->recordings.size(), std::size_t(3));
        QCOMPARE(sets.members()[1]->checkState(0), Qt::Unchecked);
        QCOMPARE(sets.currentItem(), sets.members()[1]);
        QTest::keyClick(&sets, Qt::Key_Space);
        QTRY_COMPARE(setStore().current()->recordings.size(), std::size_t(4));
        QTest::keyClick(&sets, Qt::Key_Delete);
        QCOMPARE(setStore().current()->recordings.size(), std::size_t(3));
        document().undoStack().undo();
        document().closeRecording(ids().front());
        QCOMPARE(setStore().current()->recordings.size(), std::size_t(3));
    }

    void sets_are_named_and_removed() {
        setStore().add();
        window_->action(Command::page_resonator)->trigger();
        auto& sets = the<SetTree>("sets");
        QCOMPARE(sets.topLevelItem(0)->text(0), QStringLiteral("Set 1"));
        sets.setFocus();
        sets.setCurrentItem(sets.topLevelItem(0));
        QTest::keyClick(&sets, Qt::Key_F2);
        auto* name = sets.findChild<QLineEdit*>();
        QVERIFY(name);
        name->selectAll();
        QTest::keyClicks(name, "gyro 17");
        QTest::keyClick(name, Qt::Key_Return);
        QTRY_COMPARE(setStore().current()->name, QStringLiteral("gyro 17"));
        QTRY_VERIFY(!sets.editing());
        const SetId first = setStore().current()->id;
        window_->action(Command::new_set)->trigger();
        QCOMPARE(sets.topLevelItemCount(), 2);
        QCOMPARE(sets.currentItem()->text(0), QStringLiteral("Set 2"));
        // A row of another set makes it the current one.
        QTest::keyClick(&sets, Qt::Key_Up);
        QTRY_COMPARE(setStore().current()->id, first);
        QTest::keyClick(&sets, Qt::Key_Down);
        QTRY_VERIFY(setStore().current()->id != first);
        QTest::keyClick(&sets, Qt::Key_Delete);
        QCOMPARE(sets.topLevelItemCount(), 1);
        QCOMPARE(sets.currentItem()->text(0), QStringLiteral("gyro 17"));
    }

    // A set shows how many it has, that it is identified, and its recordings alone where it is not
    // the current one.
    void each_set_has_its_recordings() {
        openRuns(files_);
        setStore().add({ids()[0], ids()[1]});
        setStore().add({ids()[2]});
        auto& sets = the<SetTree>("sets");
        QCOMPARE(sets.topLevelItemCount(), 2);
        const auto note = [&sets](int set) { return sets.topLevelItem(set)->text(1); };
        QCOMPARE(note(0), QStringLiteral("2 rec."));
        QCOMPARE(note(1), QStringLiteral("1 rec."));
        QCOMPARE(sets.topLevelItem(0)->childCount(), 2);
        QCOMPARE(sets.topLevelItem(1)->childCount(), 4);  // those that may come into it, too
        QCOMPARE(sets.members().size(), std::size_t(4));
        QVERIFY(sets.topLevelItem(1)->isExpanded());
        setStore().identify();
        QVERIFY(QTest::qWaitFor([&] { return !document().busy(); }, 60000));
        QCOMPARE(note(1), QStringLiteral("1 rec. ✓"));
        QCOMPARE(note(0), QStringLiteral("2 rec."));
        setStore().addToCurrent({ids()[3]});
        QCOMPARE(note(1), QStringLiteral("2 rec."));
    }

    // A set is called by what its recordings share, these by what differs, in the colour of their
    // tracks; what is cut off stands in the tip.
    void names_tell_what_differs_and_dots_whose_tracks_they_are() {
        openRuns(files_);
        setStore().add({ids()[0], ids()[1]});
        auto& sets = the<SetTree>("sets");
        QTRY_COMPARE(document().analyses().size(), std::size_t(4));
        const QString common = sets.topLevelItem(0)->text(0);
        QCOMPARE(common, setName(document(), *setStore().current()));
        for (std::size_t k = 0; k < sets.members().size(); ++k) {
            const QTreeWidgetItem& member = *sets.members()[k];
            const QString file = QFileInfo(files_[static_cast<int>(k)]).fileName();
            QVERIFY2(file.startsWith(common), qPrintable(common));
            QVERIFY(member.toolTip(0).contains(file));
            QVERIFY2(file.contains(QString(member.text(0)).remove(QChar(0x2026)) + ".wav"),
                     qPrintable(member.text(0)));
            QCOMPARE(member.icon(0).pixmap(8).toImage().pixelColor(4, 4).name(),
                     readable(document().analyses()[k].shown.color, lightTheme()).name());
        }
        setStore().add({ids()[2], ids()[3]});
        QCOMPARE(sets.topLevelItem(0)->text(0), common + " (1)");
        QCOMPARE(sets.topLevelItem(1)->text(0), common + " (2)");
    }

    // In the figures, too, a recording has the colour of ledger and tracks.
    void recordings_of_a_second_set_keep_their_colours() {
        openRuns(files_);
        setStore().add({ids()[2], ids()[3]});
        setStore().identify();
        QVERIFY(QTest::qWaitFor([&] { return !document().busy(); }, 60000));
        const auto colorOf = [this](std::size_t analysis) {
            return document().analyses()[analysis].shown.color;
        };
        QVERIFY(colorOf(2) != colorOf(0));
        const auto& balance = the<XYPlotView>("balance").content().series;
        const auto& rim = the<RoundView>("rim").content().series;
        for (const std::size_t run : {0, 1}) {
            QCOMPARE(curveStyle(balance.at(run).style).color, colorOf(2 + run));
            QCOMPARE(rim.at(rim.size() - 2 + run).color, colorOf(2 + run));
        }
        for (const XYSeries& series : the<XYPlotView>("drift").content().series) {
            const bool measured = series.points && series.name.startsWith("run");
            QVERIFY(!measured || curveStyle(series.style).color != colorOf(0));
        }
        window_->files().savePassportTo(home_.path("two.json"));
        QVERIFY(QTest::qWaitFor([&] { return QFile::exists(home_.path("two.json")); }));
        document().passport().open(home_.path("two.json"));
        QVERIFY(QTest::qWaitFor([&] { return document().passport().content() != nullptr; }));
        const auto& tracks = the<XYPlotView>("tracks").content().series;
        QCOMPARE(tracks.size(), std::size_t(4));
        for (const std::size_t k : {0, 1, 2, 3}) {
            QCOMPARE(curveStyle(tracks.at(k).style).color, colorOf(2 + k % 2));
        }
    }

    // Opened together they are a set: one key identifies. One opened by itself is one by itself.
    void recordings_opened_together_are_identified_by_one_key() {
        openRuns({files_[0], files_[1]});
        QVERIFY(!setStore().current());
        QTest::keyClick(window_.get(), Qt::Key_F7);
        QVERIFY(QTest::qWaitFor([&] { return !document().busy() && setStore().current(); }, 60000));
        QVERIFY(setStore().outcome(*setStore().current()));
        QCOMPARE(setStore().current()->recordings, ids());
        document().open({files_[2]});
        QVERIFY(QTest::qWaitFor([&] { return document().recordings().size() == 3 && allOpen(); }));
        setStore().add();
        document().setCurrentRecording(ids().back());
        QVERIFY(setStore().canIdentify());
        setStore().identify();
        QCOMPARE(setStore().current()->recordings, std::vector<RecordingId>{ids().back()});
    }

    // Without a set the open recordings stand alone: the first that is checked makes one.
    void a_check_mark_makes_a_set() {
        openRuns({files_[0], files_[1]});
        window_->action(Command::page_resonator)->trigger();
        auto& sets = the<SetTree>("sets");
        QCOMPARE(sets.members().size(), std::size_t(2));
        sets.setFocus();
        sets.setCurrentItem(sets.members()[1]);
        QTest::keyClick(&sets, Qt::Key_Space);
        QTRY_COMPARE(setStore().all().size(), std::size_t(1));
        QCOMPARE(setStore().current()->recordings, std::vector<RecordingId>{ids()[1]});
    }
};

VYBEG_TEST(TestSetTree, threads)

}  // namespace test_set_tree

#include "test_set_tree.moc"
