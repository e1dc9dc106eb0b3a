#include "core/recording/envelope.h"
#include "tests/core/recording/source_reading.h"

#include <QTest>

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
    extend(samples.c, bucket.c_min, bucket.c_max);
    extend(samples.d, bucket.d_min, bucket.d_max);
    return bucket;
}

bool same(const EnvelopeBucket& a, const EnvelopeBucket& b) {
    const auto equal = [](float x, float y) { return x == y || (std::isnan(x) && std::isnan(y)); };
    return equal(a.c_min, b.c_min) && equal(a.c_max, b.c_max) && equal(a.d_min, b.d_min) &&
           equal(a.d_max, b.d_max) && a.missing == b.missing;
}

std::shared_ptr<const Envelope> envelope_of(const Samples& samples) {
    return *Envelope::build(*source_of(samples), JobControl());
}

// Remembers where it was read.
class WatchedSource final : public SampleSource {
public:
    explicit WatchedSource(std::int64_t frames) : frames_(frames) {}
    std::int64_t frames() const override { return frames_; }
    Status read(std::int64_t first, std::span<double> c, std::span<double> d) const override {
        in_order = in_order && first == next;
        next = first + std::ssize(c);
        longest = std::max(longest, std::ssize(c));
        std::ranges::fill(c, 1.0);
        std::ranges::fill(d, 2.0);
        return {};
    }

    mutable bool in_order = true;
    mutable std::int64_t next = 0;
    mutable std::int64_t longest = 0;

private:
    std::int64_t frames_;
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
        QVERIFY(std::isnan(bucket.c_min) && std::isnan(bucket.c_max));
        QCOMPARE(bucket.d_min, static_cast<float>(*std::ranges::min_element(samples.d)));
        QVERIFY(bucket.missing);
    }

    void samples_beyond_a_float_are_its_largest() {
        const auto bucket = envelope_of({{1e300, 0}, {-1e300, 0}})->buckets(0, 2, 1).at(0);
        QCOMPARE(bucket.c_max, std::numeric_limits<float>::max());
        QCOMPARE(bucket.d_min, std::numeric_limits<float>::lowest());
        QVERIFY(!bucket.missing);
    }

    void the_source_is_read_once_front_to_back_in_pieces() {
        const WatchedSource source(1'000'003);
        QVERIFY(bool(Envelope::build(source, JobControl())));
        QVERIFY(source.in_order);
        QCOMPARE(source.next, source.frames());
        QVERIFY(source.longest <= 100'000);
    }

    void progress_rises_to_one() {
        std::vector<double> reported;
        const JobControl job({}, [&](double fraction) { reported.push_back(fraction); });
        QVERIFY(bool(Envelope::build(WatchedSource(1'000'003), job)));
        QVERIFY(reported.size() > 5);
        QVERIFY(std::ranges::is_sorted(reported));
        QVERIFY(reported.front() > 0);
        QCOMPARE(reported.back(), 1.0);
    }

    void it_stops_when_asked_to() {
        std::stop_source stop;
        const JobControl job(stop.get_token(), [&](double fraction) {
            if (fraction > 0.3) {
                stop.request_stop();
            }
        });
        const WatchedSource source(1'000'003);
        const auto result = Envelope::build(source, job);
        QVERIFY(!result);
        QCOMPARE(result.error().code, ErrorCode::interrupted);
        QVERIFY(source.next < source.frames() / 2);
    }

    void errors_of_the_source_are_passed_on() {
        const auto result = Envelope::build(FailingSource(100), JobControl());
        QVERIFY(!result);
        QCOMPARE(result.error(), FailingSource::error());
    }
};

QTEST_GUILESS_MAIN(TestEnvelope)
#include "test_envelope.moc"
