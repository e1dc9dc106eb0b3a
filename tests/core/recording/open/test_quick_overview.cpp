// What is seen of a long text file before it is open.
#include "core/base/number_text.h"
#include "core/recording/open/preview.h"
#include "tests/closeness.h"
#include "tests/core/recording/recording_files.h"
#include "tests/largest_of.h"
#include "tests/test_registry.h"

namespace test_quick_overview {

using namespace vybeg;
using namespace vybeg::test;

namespace {

constexpr std::int64_t row_count = 1'200'000;  // some 40 MB
constexpr double rate = 20000;

// C and D alternate between crests that fall evenly from 1 and 0.5 to 0. The rows behind the middle
// come `gap_s` later.
std::string falling(bool timed, double gap_s = 0) {
    std::string text = timed ? "t,C,D\n" : "C,D\n";
    for (std::int64_t i = 0; i < row_count; ++i) {
        const double crest = 1 - static_cast<double>(i) / static_cast<double>(row_count);
        const double sign = i % 2 == 0 ? 1 : -1;
        if (timed) {
            const double time = static_cast<double>(i) / rate + (2 * i < row_count ? 0 : gap_s);
            append_round_trip(text, time);
            text += ',';
        }
        append_round_trip(text, sign * crest);
        text += ',';
        append_round_trip(text, sign * crest / 2);
        text += '\n';
    }
    return text;
}

std::optional<QuickOverview> look_at(const std::filesystem::path& path,
                                     const OpenOptions& options = {}) {
    return quick_overview(path, options, JobControl());
}

// How far the crests are from those that were written, the largest of all parts.
double largest_error(const std::vector<EnvelopeBucket>& parts) {
    double largest = 0;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        const double crest = 1 - static_cast<double>(i) / static_cast<double>(parts.size());
        largest = largest_of({largest, std::abs(static_cast<double>(parts[i].c.max) - crest),
                              std::abs(static_cast<double>(parts[i].c.min) + crest),
                              std::abs(static_cast<double>(parts[i].d.max) - crest / 2)});
    }
    return largest;
}

}  // namespace

class TestQuickOverview : public QObject {
    Q_OBJECT

    Folder folder_;

private slots:
    void it_shows_the_crests_where_they_are() {
        const auto path = folder_.write("timed.csv", falling(true));
        const auto look = look_at(path);
        QVERIFY(look.has_value());
        VYBEG_CLOSE_RATIO(look->rate_hz, rate, 1e-6);
        VYBEG_WITHIN(look->envelope->frames(), row_count, 1);
        QVERIFY(!look->envelope->whole());
        // 256 parts at least; a column of 100 is known where the first of its parts begins.
        VYBEG_CLOSE(largest_error(look->envelope->buckets(0, look->envelope->frames(), 100)), 0,
                    0.011);
        const auto recording = opened(path);
        QCOMPARE(recording.frames(), row_count);
    }

    void a_gap_stays_empty() {
        const auto path = folder_.write("gap.csv", falling(true, 60));
        const auto look = look_at(path);
        QVERIFY(look.has_value());
        const double seconds = static_cast<double>(look->envelope->frames()) / look->rate_hz;
        VYBEG_CLOSE(seconds, 120, 0.01);
        // A quarter has rows, half of it is empty.
        const auto quarters = look->envelope->buckets(0, look->envelope->frames(), 40);
        for (int i = 0; i < 40; ++i) {
            const bool in_gap = i > 10 && i < 29;
            QVERIFY(quarters[i].coverage == (in_gap ? Coverage::none : Coverage::some) || i == 10 ||
                    i == 29);
        }
    }

    void without_times_its_length_is_about_that_of_the_rows() {
        const auto path = folder_.write("rows.csv", falling(false));
        QVERIFY(!look_at(path));  // needs a rate
        const OpenOptions with_rate{.rate_hz = rate};
        const auto look = look_at(path, with_rate);
        QVERIFY(look.has_value());
        QCOMPARE(look->rate_hz, rate);
        const auto frames = static_cast<double>(look->envelope->frames());
        VYBEG_CLOSE_RATIO(frames, static_cast<double>(row_count), 0.1);
        VYBEG_CLOSE(largest_error(look->envelope->buckets(0, look->envelope->frames(), 50)), 0,
                    0.05);
    }

    void channels_are_those_of_the_options() {
        const auto path = folder_.write("swapped.csv", falling(true));
        const OpenOptions swapped{.channel_c = 2, .channel_d = 1};
        const auto look = look_at(path, swapped);
        QVERIFY(look.has_value());
        const auto first = look->envelope->buckets(0, 1000, 1).at(0);
        VYBEG_CLOSE(first.c.max, 0.5F, 0.01F);
        VYBEG_CLOSE(first.d.max, 1.0F, 0.01F);
    }

    void nothing_is_shown_of_what_opens_at_once_or_not_at_all() {
        QVERIFY(!look_at(folder_.write("short.csv", falling(true).substr(0, 1'000'000))));
        QVERIFY(!look_at(folder_.write("binary.dat", std::string(50'000'000, '\0'))));
        QVERIFY(!look_at(folder_.write("words.csv", std::string(50'000'000, 'w'))));
        QVERIFY(!look_at(folder_.file("missing.csv")));
        std::string text = falling(true);
        text += "1e300,0,0\n";  // no time that rows could lie under
        QVERIFY(!look_at(folder_.write("far.csv", text)));
        text = falling(true);
        text.replace(0, 6, "-1\n58\n");
        QVERIFY(!look_at(folder_.write("universal.uff", text)));
    }
};

VYBEG_TEST(TestQuickOverview, threads)

}  // namespace test_quick_overview

#include "test_quick_overview.moc"
