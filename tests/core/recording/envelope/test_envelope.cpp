#include "core/recording/envelope/envelope.h"
#include "tests/closeness.h"
#include "tests/core/recording/source_reading.h"
#include "tests/test_registry.h"

#include <QTest>

#include <numeric>

namespace test_envelope {

using namespace vybeg;
using namespace vybeg::test;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// Noise in which runs of 1 to 50 samples are missing in C, D or both.
Samples holed_noise(std::int64_t frames, std::uint64_t seed) {
    Samples samples = noise(frames, seed);
    std::mt19937_64 random(seed);
    for (std::int64_t at = 0; at < frames; at += static_cast<std::int64_t>(1 + random() % 400)) {
        const double value = std::array{no_value, infinity, -infinity}[random() % 3];
        const bool in_c = random() % 2 == 0;
        const bool in_d = !in_c || random() % 2 == 0;
        const auto end = std::min(frames, at + static_cast<std::int64_t>(1 + random() % 50));
        for (; at < end; ++at) {
            samples.c[at] = in_c ? value : samples.c[at];
            samples.d[at] = in_d ? value : samples.d[at];
        }
    }
    return samples;
}

EnvelopeBucket by_brute_force(const Samples& samples, std::int64_t first, std::int64_t end) {
    EnvelopeBucket bucket;
    const auto extend = [&](const std::vector<double>& x, float& min, float& max) {
        min = max = std::numeric_limits<float>::quiet_NaN();
        for (std::int64_t i = first; i < end; ++i) {
            if (!std::isfinite(x[i])) {
                bucket.missing = true;
                continue;
            }
            min = std::fmin(min, static_cast<float>(x[i]));
            max = std::fmax(max, static_cast<float>(x[i]));
        }
    };
    extend(samples.c, bucket.c.min, bucket.c.max);
    extend(samples.d, bucket.d.min, bucket.d.max);
    return bucket;
}

bool same(const EnvelopeBucket& a, const EnvelopeBucket& b) {
    const auto equal = [](float x, float y) { return x == y || (std::isnan(x) && std::isnan(y)); };
    return equal(a.c.min, b.c.min) && equal(a.c.max, b.c.max) && equal(a.d.min, b.d.min) &&
           equal(a.d.max, b.d.max) && a.missing == b.missing;
}

std::shared_ptr<const Envelope> envelope_of(const Samples& samples) {
    return *build_envelope(*source_of(samples), JobControl());
}

// Remembers where it was read.
class CheckedSource final : public SampleSource {
public:
    explicit CheckedSource(std::int64_t frames) : frames_(frames) {}
    std::int64_t frames() const override { return frames_; }
    Status read(std::int64_t first, std::span<double> c, std::span<double> d) const override {
        in_order = in_order && first == next;
        next = first + std::ssize(c);
        longest = std::max(longest, std::ssize(c));
        std::ranges::fill(c, 1.0);
        std::ranges::fill(d, 2.0);
        return {};
    }

    bool seeks() const override { return seeking; }

    bool seeking = true;
    mutable bool in_order = true;
    mutable std::int64_t next = 0;
    mutable std::int64_t longest = 0;

private:
    std::int64_t frames_;
};

// C counts the frames.
class RisingSource final : public SampleSource {
public:
    explicit RisingSource(std::int64_t frames) : frames_(frames) {}
    std::int64_t frames() const override { return frames_; }
    Status read(std::int64_t first, std::span<double> c, std::span<double> d) const override {
        std::iota(c.begin(), c.end(), static_cast<double>(first));
        std::ranges::fill(d, 0.0);
        looked += c.size() < 1000 ? std::ssize(c) : 0;
        return {};
    }

    mutable std::int64_t looked = 0;  // in reads of less than 1000 frames

private:
    std::int64_t frames_;
};

// Pictures of a growing envelope, with a clock that goes on by one step whenever it is read.
struct Pictures {
    explicit Pictures(double clock_step_s)
        : job({}, {}, [this, clock_step_s] { return time_s += clock_step_s; }) {}

    double time_s = 0;
    JobControl job;
    std::vector<std::shared_ptr<const Envelope>> taken;
    EnvelopeSink sink = [this](auto picture) { taken.push_back(std::move(picture)); };
};

}  // namespace

class TestEnvelope : public QObject {
    Q_OBJECT

private slots:
    void buckets_are_the_extremes_of_their_frames_data() {
        QTest::addColumn<qint64>("frames");
        for (const qint64 frames :
             {1, 15, 16, 17, 255, 256, 257, 4095, 4096, 4097, 65535, 65536, 65537, 200001}) {
            QTest::newRow(qPrintable(QString::number(frames))) << frames;
        }
    }

    void buckets_are_the_extremes_of_their_frames() {
        QFETCH(qint64, frames);
        for (const Samples& samples : {noise(frames, 1), holed_noise(frames, 2)}) {
            const auto envelope = envelope_of(samples);
            QCOMPARE(envelope->frames(), frames);
            std::mt19937_64 random(9);
            for (int trial = 0; trial < 200; ++trial) {
                const auto first = static_cast<std::int64_t>(random() % frames);
                const auto end = first + 1 + static_cast<std::int64_t>(random() % (frames - first));
                const int count = static_cast<int>(1 + random() % 12);
                const auto buckets = envelope->buckets(first, end, count);
                QCOMPARE(std::ssize(buckets), count);
                for (int i = 0; i < count; ++i) {
                    const std::int64_t from = first + (end - first) * i / count;
                    const std::int64_t to =
                        std::max(from + 1, first + (end - first) * (i + 1) / count);
                    const EnvelopeBucket expected =
                        by_brute_force(samples, from / 16 * 16,
                                       std::min<std::int64_t>((to + 15) / 16 * 16, frames));
                    QVERIFY2(same(buckets[i], expected),
                             qPrintable(QString("%1 to %2").arg(from).arg(to)));
                }
            }
        }
    }

    void the_whole_recording_is_one_bucket() {
        const Samples samples = holed_noise(300000, 3);
        const auto whole = envelope_of(samples)->buckets(0, 300000, 1);
        QVERIFY(same(whole.at(0), by_brute_force(samples, 0, 300000)));
    }

    void a_channel_that_is_missing_is_nan_beside_one_that_is_not() {
        Samples samples = noise(64, 4);
        std::fill(samples.c.begin(), samples.c.end(), no_value);
        const auto bucket = envelope_of(samples)->buckets(0, 64, 1).at(0);
        QVERIFY(std::isnan(bucket.c.min) && std::isnan(bucket.c.max));
        QCOMPARE(bucket.d.min, static_cast<float>(*std::ranges::min_element(samples.d)));
        QVERIFY(bucket.missing);
    }

    void samples_beyond_a_float_are_its_largest() {
        const auto bucket = envelope_of({{1e300, 0}, {-1e300, 0}})->buckets(0, 2, 1).at(0);
        QCOMPARE(bucket.c.max, std::numeric_limits<float>::max());
        QCOMPARE(bucket.d.min, std::numeric_limits<float>::lowest());
        QVERIFY(!bucket.missing);
    }

    void the_source_is_read_once_front_to_back_in_pieces() {
        const CheckedSource source(1'000'003);
        QVERIFY(bool(build_envelope(source, JobControl())));
        QVERIFY(source.in_order);
        QCOMPARE(source.next, source.frames());
        VYBEG_AT_MOST(source.longest, 100'000);
    }

    void progress_rises_to_one() {
        std::vector<double> reported;
        const JobControl job({}, [&](double fraction) { reported.push_back(fraction); });
        QVERIFY(bool(build_envelope(CheckedSource(1'000'003), job)));
        VYBEG_MORE(reported.size(), 5);
        QVERIFY(std::ranges::is_sorted(reported));
        VYBEG_MORE(reported.front(), 0);
        QCOMPARE(reported.back(), 1.0);
    }

    void it_stops_when_asked_to() {
        std::stop_source stop;
        const JobControl job(stop.get_token(), [&](double fraction) {
            if (fraction > 0.3) {
                stop.request_stop();
            }
        });
        const CheckedSource source(1'000'003);
        const auto result = build_envelope(source, job);
        QVERIFY(!result);
        QCOMPARE(result.error().code, ErrorCode::interrupted);
        VYBEG_LESS(source.next, source.frames() / 2);
    }

    void it_is_shown_as_it_grows() {
        const Samples samples = holed_noise(1'000'003, 5);
        const auto source = source_of(samples);
        Pictures pictures(0.05);
        const auto whole = build_envelope(*source, pictures.job, pictures.sink);
        QVERIFY((*whole)->whole());
        VYBEG_MORE(pictures.taken.size(), 3);
        std::int64_t read_before = -1;
        for (const auto& picture : pictures.taken) {
            QCOMPARE(picture->frames(), std::int64_t{1'000'003});
            QVERIFY(!picture->whole());
            // Front to back: where all has been read the values are those of the end.
            std::int64_t read = 0;
            while (read < 1'000'000 &&
                   picture->buckets(read, read + 8, 1).at(0).coverage == Coverage::all) {
                QVERIFY(same(picture->buckets(read, read + 8, 1).at(0),
                             by_brute_force(samples, read / 16 * 16, read / 16 * 16 + 16)));
                read += 10'000;
            }
            VYBEG_MORE(read, read_before);
            VYBEG_LESS(read, 1'000'000);
            read_before = read;
        }
    }

    void a_first_look_is_spread_over_the_whole_recording() {
        constexpr std::int64_t frames = 10'000'000;
        constexpr int columns = 100;
        const RisingSource source(frames);
        Pictures pictures(0);
        QVERIFY(bool(build_envelope(source, pictures.job, pictures.sink)));
        const auto buckets = pictures.taken.at(0)->buckets(0, frames, columns);
        for (int i = 0; i < columns; ++i) {
            // 2048 parts: a column holds 20 of them, each known by its beginning.
            QVERIFY(buckets[i].coverage == Coverage::some);
            VYBEG_WITHIN(static_cast<double>(buckets[i].c.min), 1e5 * i, 1e4);
            VYBEG_WITHIN(static_cast<double>(buckets[i].c.max), 1e5 * (i + 1), 1e4);
        }
        // 2048 looks of 256 frames.
        VYBEG_AT_MOST(source.looked, frames / 16);
    }

    void a_slow_disk_gives_a_coarser_first_look_or_none() {
        constexpr std::int64_t frames = 10'000'000;
        // 0.3 s for looks of 1.5 ms: 128 are ready in time, 256 are not. Of 10 ms: not even 64.
        for (const auto& [clock_step_s, parts] : {std::pair{0.0015, 128}, {0.010, 0}}) {
            const RisingSource source(frames);
            Pictures pictures(clock_step_s);
            QVERIFY(bool(build_envelope(source, pictures.job, pictures.sink)));
            const auto buckets = pictures.taken.at(0)->buckets(frames / 2, frames, 1000);
            std::vector<float> different;
            for (const EnvelopeBucket& bucket : buckets) {
                QVERIFY(bucket.coverage == (parts > 0 ? Coverage::some : Coverage::none));
                if (parts > 0) {
                    different.push_back(bucket.c.min);
                }
            }
            const auto rest = std::ranges::unique(different);
            QCOMPARE(std::distance(different.begin(), rest.begin()), parts / 2);
        }
    }

    void a_source_that_cannot_seek_is_not_looked_at_in_advance() {
        CheckedSource source(10'000'000);
        source.seeking = false;
        Pictures pictures(0.02);
        QVERIFY(bool(build_envelope(source, pictures.job, pictures.sink)));
        QVERIFY(source.in_order);
        VYBEG_MORE(pictures.taken.size(), 3);
        const auto last = pictures.taken.at(0)->buckets(9'999'000, 10'000'000, 1);
        QVERIFY(last.at(0).coverage == Coverage::none);
        QVERIFY(std::isnan(last.at(0).c.min));
    }

    void a_picture_keeps_what_it_showed() {
        const Samples samples = noise(2'000'000, 6);
        Pictures pictures(0.05);
        const auto source = source_of(samples);
        std::vector<EnvelopeBucket> then;
        const auto whole = build_envelope(*source, pictures.job, [&](const auto& picture) {
            pictures.sink(picture);
            if (pictures.taken.size() == 2) {
                then = picture->buckets(0, 2'000'000, 50);
            }
        });
        const auto now = pictures.taken.at(1)->buckets(0, 2'000'000, 50);
        QVERIFY(std::ranges::equal(then, now, same));
        QVERIFY(!std::ranges::equal(now, (*whole)->buckets(0, 2'000'000, 50), same));
    }

    void errors_of_the_source_are_passed_on() {
        const auto result = build_envelope(FailingSource(100), JobControl());
        QVERIFY(!result);
        QCOMPARE(result.error(), FailingSource::error());
    }
};

VYBEG_TEST(TestEnvelope, threads)

}  // namespace test_envelope

#include "test_envelope.moc"
