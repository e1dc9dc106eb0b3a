// 10,000 damaged files for each reader of ours: no crash (the sanitizers' run has it, too), no
// more than 2 s of processor time, no more memory than the file's size and 64 MB.
#include "tests/closeness.h"
#include "tests/fuzz/heap_peak.h"
#include "tests/fuzz/mutation.h"
#include "tests/fuzz/seeds.h"
#include "tests/fuzz/trial.h"
#include "tests/test_registry.h"

#include <QTest>

#include <algorithm>
#include <array>
#include <ctime>
#include <string>

namespace test_mutated_files {

using namespace vybeg::fuzz;

namespace {

constexpr std::uint64_t files = 10000;
constexpr double longest_s = 2;
constexpr std::int64_t memory_bytes = std::int64_t{64} << 20;

double processor_s() {
    timespec time{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

}  // namespace

class TestMutatedFiles : public QObject {
    Q_OBJECT

private slots:
    void the_heap_is_counted() {
        start_heap_peak();
        { const std::vector<char> some(1 << 20); }
        const std::int64_t one = heap_peak();
        VYBEG_AT_LEAST(one, 1 << 20);
        VYBEG_LESS(one, (1 << 20) + 100000);
        start_heap_peak();
        VYBEG_LESS(heap_peak(), 100000);
    }

    void sound_files_are_read_data() { formats(); }

    void sound_files_are_read() {
        QFETCH(std::string, format);
        const TryFile try_file = reader_of(format);
        for (const std::string& bytes : sound_files(format)) {
            const Verdict verdict = try_file(bytes);
            QCOMPARE(verdict.fault, std::string());
            QVERIFY(verdict.outcome == Outcome::read);
        }
    }

    void damaged_files_do_no_harm_data() { formats(); }

    void damaged_files_do_no_harm() {
        QFETCH(std::string, format);
        const TryFile try_file = reader_of(format);
        const std::vector<std::string> sound = sound_files(format);
        // Formats without packing and checksums: what opens with wrong bits can be read.
        const bool is_plain =
            format == "wav" || format == "npy" || format == "uff" || format == "tdms";
        std::array<std::uint64_t, 3> outcomes{};
        double slowest_s = 0;
        std::int64_t most_bytes = 0;
        for (std::uint64_t seed = 0; seed < files; ++seed) {
            const Mutation mutation = mutated(sound, seed);
            const double start_s = processor_s();
            start_heap_peak();
            const Verdict verdict = try_file(mutation.bytes);
            const std::int64_t bytes = heap_peak();
            const double seconds = processor_s() - start_s;
            const QString place = QString("seed %1 (%2): %3, %4 bytes, %5 s")
                                      .arg(seed)
                                      .arg(mutation.what.c_str(), verdict.fault.c_str())
                                      .arg(bytes)
                                      .arg(seconds);
            QVERIFY2(verdict.fault.empty(), qPrintable(place));
            QVERIFY2(!is_plain || mutation.what != "bits" || verdict.outcome != Outcome::unreadable,
                     qPrintable(place));
            VYBEG_AT_MOST(bytes, static_cast<std::int64_t>(mutation.bytes.size()) + memory_bytes,
                          qPrintable(place));
            VYBEG_LESS(seconds, longest_s, qPrintable(place));
            ++outcomes[static_cast<std::size_t>(verdict.outcome)];
            slowest_s = std::max(slowest_s, seconds);
            most_bytes = std::max(most_bytes, bytes);
        }
        const auto [refused, unreadable, read] = outcomes;
        qInfo("%d refused, %d unreadable, %d read; slowest %.0f ms, at most %.1f MB",
              static_cast<int>(refused), static_cast<int>(unreadable), static_cast<int>(read),
              1e3 * slowest_s, 1e-6 * static_cast<double>(most_bytes));
        VYBEG_MORE(refused, files / 50);
        VYBEG_MORE(read, files / 50);
    }

private:
    static void formats() {
        QTest::addColumn<std::string>("format");
        for (const std::string& name : readers()) {
            QTest::newRow(name.c_str()) << name;
        }
    }
};

VYBEG_TEST(TestMutatedFiles, first)

}  // namespace test_mutated_files

#include "test_mutated_files.moc"
