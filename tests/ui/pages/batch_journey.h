#pragma once

#include "tests/app/cli_run.h"
#include "tests/ui/gui_test.h"
#include "tests/ui/resonator_runs.h"
#include "ui/batch/batch_window.h"

#include <QAction>
#include <QApplication>
#include <QHeaderView>
#include <QLabel>
#include <QMessageBox>
#include <QPushButton>
#include <QTableView>
#include <QtTest>

#include <array>
#include <cstdint>

namespace vybeg::ui {

// A window with the window of a batch, for a list of three good sets and one whose recording is
// broken, as an engineer works with it.
class BatchJourney : public QObject, protected WindowTest {
protected:
    static constexpr int most_ms = 120'000;
    static constexpr std::array titles{"Set",   "Gyro", "State", "Verdict", "Frequency split\nmHz",
                                       "Reason"};
    enum Title : std::uint8_t { set_name, gyro, state, verdict, split, reason };

    QByteArray expected_;  // the table of the command line

    BatchWindow& batch() { return childOf<BatchWindow>(*window_); }
    QTableView& table() { return childOf<QTableView>(batch(), "batchTable"); }
    QAbstractItemModel& model() { return *table().model(); }
    QPushButton& button(const char* name) { return childOf<QPushButton>(batch(), name); }
    QString progressText() { return childOf<QLabel>(batch(), "batchProgress").text(); }
    QString message() { return childOf<QLabel>(batch(), "batchMessage").text(); }

    int column(const QString& title) {
        for (int k = 0; k < model().columnCount(); ++k) {
            if (model().headerData(k, Qt::Horizontal).toString() == title) {
                return k;
            }
        }
        return -1;
    }
    QString text(int row, Title title) {
        return model().index(row, column(titles[title])).data().toString();
    }
    QStringList names() {
        QStringList all;
        for (int row = 0; row < model().rowCount(); ++row) {
            all << text(row, set_name);
        }
        return all;
    }
    int rowOf(const QString& name) { return static_cast<int>(names().indexOf(name)); }

    // Opened by the menu's command, with the files typed.
    void open(const QString& list, const QString& results) {
        window_->action(Command::batch)->trigger();
        QVERIFY(QTest::qWaitForWindowExposed(&batch()));
        batch().form().setPath(BatchPath::list, list);
        batch().form().setPath(BatchPath::results, results);
    }
    void press(const char* name) { QTest::mouseClick(&button(name), Qt::LeftButton); }
    // Runs to the end.
    void run() {
        press("batchStart");
        QVERIFY(batch().running());
        QTRY_VERIFY_WITH_TIMEOUT(!batch().running(), most_ms);
    }
    // Presses Stop at the first row. A window that is kept from running for long may meet the end
    // of the batch instead: then it is done again.
    void stopMidway(const QString& results) {
        for (int trial = 0; trial < 20; ++trial) {
            QFile::remove(results);
            open(home_.path("list.csv"), results);
            const auto first = connect(&model(), &QAbstractItemModel::dataChanged, this, [this] {
                if (button("batchStop").isEnabled()) {
                    press("batchStop");
                }
            });
            press("batchStart");
            QTRY_VERIFY_WITH_TIMEOUT(!batch().running(), most_ms);
            disconnect(first);
            if (message().startsWith("Stopped. What")) {
                return;
            }
        }
        QFAIL("never stopped midway");
    }
    void clickHeader(const QString& title) {
        QHeaderView* header = table().horizontalHeader();
        table().scrollTo(model().index(0, column(title)));
        const QPoint at(header->sectionViewportPosition(column(title)) + 20, header->height() / 2);
        QTest::mouseClick(header->viewport(), Qt::LeftButton, {}, at);
    }
    void clickAnswer(const QString& answer) {
        QTRY_VERIFY(batch().findChild<QMessageBox*>());
        for (QAbstractButton* each : childOf<QMessageBox>(batch()).buttons()) {
            if (each->text() == answer) {
                QTest::mouseClick(each, Qt::LeftButton);
                return;
            }
        }
        QFAIL(qPrintable("no such answer: " + answer));
    }

    // The list, its recordings, and the table of the command line.
    void prepare() {
        QByteArray list = "set,gyro,file,from,date,lot\n";
        // Not in the order of their splits.
        for (const auto& [name, split_hz] :
             {std::pair{"HRG-2", 0.02}, std::pair{"HRG-10", 0.01}, std::pair{"HRG-1", 0.03}}) {
            const QString prefix = QString::fromLatin1(name) + "_";
            for (const QString& path : resonatorRuns(home_, prefix, {split_hz, 0.2, 40})) {
                list += QByteArray(name) + ',' + name + ',' + QFileInfo(path).fileName().toUtf8() +
                        ",0.1,2026-03-31,\"a \"\"b\"\", c\"\n";
            }
            if (list.count("HRG-10") > 0 && !list.contains("broken")) {
                list += "broken,HRG-3,broken.wav,,,\n";
            }
        }
        home_.file("list.csv", list);
        home_.file("broken.wav", "RIFF\x10WAVEnothing");
        const auto outcome =
            test::run_cli({"batch", home_.path("list.csv"), "-o", "cli.csv"}, home_.path("."));
        QCOMPARE(outcome.status, 0);
        expected_ = test::content(home_.path("cli.csv"));
        const QByteArray program = expected_.left(expected_.indexOf('\n'));
        QVERIFY(program.startsWith("# vybeg-cli "));
        QCoreApplication::setApplicationVersion(program.mid(12));
    }
};

}  // namespace vybeg::ui
