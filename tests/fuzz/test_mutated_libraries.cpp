// 10,000 damaged HDF5 files and as many of audio, read as vybeg-reader reads them, in processes
// that may die as it may: the libraries fall on some of them. What must not be is that our own code
// between falls, or that more memory is taken than vybeg-reader has. That the program outlives its
// vybeg-reader, and gives it up where it does not come to an end, is for
// tests/core/recording/variables/test_damaged_libraries.
#include "tests/closeness.h"
#include "tests/fuzz/batch.h"
#include "tests/fuzz/mutation.h"
#include "tests/fuzz/seeds.h"
#include "tests/fuzz/trial.h"
#include "tests/test_registry.h"

#include <QTest>

#include <array>

namespace test_mutated_libraries {

using namespace vybeg::fuzz;

namespace {

constexpr std::uint64_t files = 10000;

}  // namespace

class TestMutatedLibraries : public QObject {
    Q_OBJECT

private slots:
    void sound_files_are_read_data() { formats(); }

    void sound_files_are_read() {
        const TryFile try_file = library_of(QTest::currentDataTag());
        const std::vector<std::string> sound = sound_files(QTest::currentDataTag());
        const BatchCount count = try_batch(
            0, sound.size(),
            [&](std::uint64_t i) {
                return Mutation{sound[i], "none"};
            },
            try_file);
        QCOMPARE(count.faults, std::vector<std::string>());
        QCOMPARE(count.outcomes[static_cast<std::size_t>(Outcome::read)], sound.size());
    }

    void damaged_files_do_no_harm_data() { formats(); }

    void damaged_files_do_no_harm() {
        const TryFile try_file = library_of(QTest::currentDataTag());
        QFETCH(std::uint64_t, count);
        const std::vector<std::string> sound = sound_files(QTest::currentDataTag());
        const BatchCount found = try_batch(
            0, count, [&](std::uint64_t seed) { return mutated(sound, seed); }, try_file);
        const auto [refused, unreadable, read] = found.outcomes;
        qInfo("%d refused, %d unreadable, %d read, %d deaths of the library, %d without end",
              static_cast<int>(refused), static_cast<int>(unreadable), static_cast<int>(read),
              static_cast<int>(found.deaths), static_cast<int>(found.endless));
        QVERIFY2(found.faults.empty(), found.faults.empty() ? "" : found.faults.front().c_str());
        QCOMPARE(refused + unreadable + read + found.deaths + found.endless, count);
        VYBEG_MORE(refused, count / 50);
        VYBEG_MORE(read, count / 50);
        VYBEG_LESS(found.deaths, count / 100);
        VYBEG_LESS(found.endless, count / 500);  // vybeg-reader is given up after 5 s
    }

    void groups_in_each_other_without_bottom_are_refused() {
        const std::string deep = sound_files("bottomless").front();
        const BatchCount found = try_batch(
            0, 1,
            [&](std::uint64_t) {
                return Mutation{deep, "deep"};
            },
            library_of("hdf5"));
        QCOMPARE(found.outcomes[static_cast<std::size_t>(Outcome::refused)], std::uint64_t{1});
        QCOMPARE(found.faults, std::vector<std::string>());
        VYBEG_LESS(found.slowest_s, 1);
    }

    void faults_and_files_without_end_are_told() {
        const BatchCount found = try_batch(
            0, 3,
            [](std::uint64_t) {
                return Mutation{"", "none"};
            },
            [](std::string_view) -> Verdict {
                return {Outcome::read, "a fault"};
            });
        QCOMPARE(found.faults.size(), std::size_t{3});
        const BatchCount endless = try_batch(
            7, 1,
            [](std::uint64_t) {
                return Mutation{"", "none"};
            },
            [](std::string_view) -> Verdict {
                const volatile bool on = true;
                while (on) {
                }
                return {};
            });
        QCOMPARE(endless.endless, std::uint64_t{1});
    }

private:
    static void formats() {
        QTest::addColumn<std::uint64_t>("count");
        // Two namings of one reader.
        QTest::newRow("mat73") << files / 4;
        QTest::newRow("hdf5") << files - files / 4;
        QTest::newRow("audio") << files;
    }
};

VYBEG_TEST(TestMutatedLibraries, first)

}  // namespace test_mutated_libraries

#include "test_mutated_libraries.moc"
