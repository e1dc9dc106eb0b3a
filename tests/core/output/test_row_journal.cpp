// Rows that outlive the program, and those of which only a part does.
#include "core/base/error.h"
#include "core/output/row_journal.h"
#include "tests/closeness.h"
#include "tests/needed.h"
#include "tests/small_files.h"
#include "tests/test_registry.h"

#include <QTemporaryDir>
#include <QtTest>

#include <memory>
#include <optional>
#include <random>

namespace test_row_journal {

using namespace vybeg;
using namespace vybeg::test;

namespace {

std::string key_of(int k) {
    return "key" + std::to_string(k);
}

std::string row_of(int k) {
    return "set " + std::to_string(k) + ",1.5,\"a b\"" +
           std::string(static_cast<std::size_t>(k), 'x');
}

}  // namespace

class TestRowJournal : public QObject {
    Q_OBJECT

    std::unique_ptr<QTemporaryDir> folder_;
    QString path_;

    RowJournal open(bool resume) const {
        return needed(RowJournal::open(path_.toStdString(), resume));
    }

    void write_rows(int count) const {
        RowJournal journal = open(false);
        for (int k = 0; k < count; ++k) {
            QVERIFY(journal.append(key_of(k), row_of(k)));
        }
    }

private slots:
    void init() {
        folder_ = std::make_unique<QTemporaryDir>();
        path_ = folder_->filePath("table.csv.unfinished");
    }

    void a_later_run_finds_the_rows() {
        write_rows(5);
        RowJournal journal = open(true);
        for (int k = 4; k >= 0; --k) {
            QVERIFY(journal.has(key_of(k)));
            QCOMPARE(journal.row(key_of(k)), row_of(k));
        }
        QVERIFY(!journal.has("key5"));
        QVERIFY(journal.append("key5", row_of(5)));
        QCOMPARE(journal.row("key5"), row_of(5));
        QCOMPARE(journal.row("key2"), row_of(2));
    }

    void without_resume_it_begins_without_rows_and_keeps_those_of_the_file() {
        write_rows(5);
        {
            RowJournal journal = open(false);
            QVERIFY(!journal.has("key0") && !journal.empty());
            QCOMPARE(journal.found(), std::size_t{5});
            QVERIFY(journal.append("key0", "anew"));
        }
        const RowJournal journal = open(true);
        QCOMPARE(journal.found(), std::size_t{0});
        QCOMPARE(journal.row("key0"), std::string("anew"));
        QCOMPARE(journal.row("key4"), row_of(4));
    }

    // Every length to which a file may be cut, and a wrong byte at many places.
    void a_damaged_row_does_not_count_and_the_others_do() {
        write_rows(4);
        const QByteArray whole = content(path_);
        const auto rows_found = [this] {
            RowJournal journal = open(true);
            int found = 0;
            for (int k = 0; k < 4; ++k) {
                if (journal.has(key_of(k))) {
                    found += journal.row(key_of(k)) == row_of(k) ? 1 : -100;
                }
            }
            // A row after the damage is whole.
            const bool appended = static_cast<bool>(journal.append("more", "row"));
            return appended ? found : -1000;
        };
        for (qsizetype size = 0; size <= whole.size(); ++size) {
            QVERIFY(put(path_, whole.left(size)));
            const qsizetype lines = whole.left(size).count('\n');
            QCOMPARE(rows_found(), static_cast<int>(std::max<qsizetype>(lines - 1, 0)));
            RowJournal again = open(true);
            QVERIFY(again.has("more"));
            QCOMPARE(again.row("more"), "row");
        }
        std::mt19937 random(7);
        const qsizetype head = whole.indexOf('\n') + 1;
        for (int trial = 0; trial < 200; ++trial) {
            QByteArray damaged = whole;
            const auto rest = static_cast<unsigned>(whole.size() - head);
            const qsizetype at = head + static_cast<qsizetype>(random() % rest);
            damaged[at] = static_cast<char>(damaged[at] ^ static_cast<char>(1 + random() % 255));
            QVERIFY(put(path_, damaged));
            const int found = rows_found();
            // A line feed that is damaged, or made, takes one row or the next one with it.
            VYBEG_AT_LEAST(found, 2);
            VYBEG_AT_MOST(found, 3);
        }
    }

    void another_run_at_work_keeps_it() {
        const RowJournal at_work = open(false);
        const auto second = RowJournal::open(path_.toStdString(), true);
        QVERIFY(!second);
        QCOMPARE(exit_status(second.error().code), 5);
        QVERIFY(english(second.error()).find("another program") != std::string::npos);
    }

    void another_kind_of_file_is_not_lost() {
        QVERIFY(put(path_, "a,b\n1,2\n"));
        for (const bool resume : {false, true}) {
            const auto journal = RowJournal::open(path_.toStdString(), resume);
            QVERIFY(!journal);
            QVERIFY(english(journal.error()).find("another kind of file") != std::string::npos);
            QCOMPARE(content(path_), QByteArray("a,b\n1,2\n"));
        }
    }

    void it_goes_when_the_rows_are_in_their_table() {
        RowJournal journal = open(false);
        QVERIFY(QFile::exists(path_));
        journal.remove();
        QVERIFY(!QFile::exists(path_));
    }

    void without_a_name_it_keeps_the_rows_of_one_run() {
        auto journal = RowJournal::open("", false);
        QVERIFY(journal);
        QVERIFY(journal->append("a", "row a"));
        QVERIFY(journal->append("b", "row b"));
        QCOMPARE(journal->row("a"), "row a");
        journal->remove();
    }
};

VYBEG_TEST(TestRowJournal)

}  // namespace test_row_journal

#include "test_row_journal.moc"
