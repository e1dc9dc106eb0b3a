// The layout of a headerless file from its first samples: 8 layouts, waves at several angles and
// frequencies, with noise, as counts of 12 to 24 bits, with an offset, behind headers.
#include "core/recording/arrays/raw_guess.h"
#include "core/recording/bytes/byte_order.h"
#include "core/recording/samples/open_table.h"
#include "core/simulation/free_decay.h"
#include "core/simulation/simulate.h"
#include "tests/core/recording/recording_files.h"
#include "tests/test_registry.h"

#include <cmath>
#include <random>

namespace test_raw_guess {

using namespace vybeg;
using namespace vybeg::test;

namespace {

std::string encoded(double sample, const RawLayout& layout) {
    switch (layout.type) {
        case RawType::i16:
            return store(static_cast<std::int16_t>(std::lrint(sample)), layout.big_endian);
        case RawType::i32:
            return store(static_cast<std::int32_t>(std::lrint(sample)), layout.big_endian);
        case RawType::f32: return store(static_cast<float>(sample), layout.big_endian);
        case RawType::f64: return store(sample, layout.big_endian);
    }
    return "";
}

std::string encoded(const SimulatedDecay& decay, double amplitude, double offset,
                    const RawLayout& layout) {
    std::string bytes;
    for (std::size_t i = 0; i < decay.c.size(); ++i) {
        bytes += encoded(amplitude * decay.c[i] + offset, layout);
        bytes += encoded(amplitude * decay.d[i] + offset, layout);
    }
    return bytes;
}

SimulatedDecay decay(double f0_hz, double two_theta_A, double noise = 0.00707) {
    FreeDecay settings = demo_decay();
    settings.seconds = 1;
    settings.f0_hz = f0_hz;
    settings.two_theta_A = two_theta_A;
    settings.noise = noise;  // 40 dB below an amplitude of 1
    settings.bits = 0;
    const auto simulated = simulate(settings, {});
    return simulated ? *simulated : SimulatedDecay{};
}

RawLayout guessed(const std::filesystem::path& path) {
    const auto file = FileBytes::open(path);
    if (!file) {
        qFatal("%s", english(file.error()).c_str());
    }
    const auto guess = guess_raw_layout(**file);
    return guess && *guess ? **guess : RawLayout{.channels = 0};
}

QByteArray text_of(const RawLayout& layout) {
    OpenOptions options;
    options.raw = layout;
    return QByteArray::fromStdString(options_text(options));
}

}  // namespace

class TestRawGuess : public QObject {
    Q_OBJECT

    Folder folder_;

private slots:
    void every_layout_is_found_in_every_recording_data() {
        QTest::addColumn<double>("f0_hz");
        QTest::addColumn<double>("two_theta_A");
        QTest::addColumn<double>("counts");  // of an amplitude of 1 in whole numbers
        QTest::addColumn<double>("offset");  // of those
        for (const int counts : {100, 1800, 20000}) {
            for (const double f0 : {5300.0, 500.0, 33333.0 / 4, 12000.0}) {
                for (const double angle : {0.0, 0.3, 0.785398, -1.3}) {
                    QTest::addRow("%d counts, %.0f Hz, %.1f", counts, f0, angle)
                        << f0 << angle << 1.0 * counts << 0.0;
                }
            }
        }
        QTest::newRow("offset binary") << 5300.0 << 0.3 << 1800.0 << 2048.0;
    }
    void every_layout_is_found_in_every_recording() {
        QFETCH(double, f0_hz);
        QFETCH(double, two_theta_A);
        QFETCH(double, counts);
        QFETCH(double, offset);
        const SimulatedDecay wave = decay(f0_hz, two_theta_A);
        for (const RawType type : {RawType::i16, RawType::i32, RawType::f32, RawType::f64}) {
            for (const bool big : {false, true}) {
                const RawLayout layout{.type = type, .big_endian = big};
                const bool whole = type == RawType::i16 || type == RawType::i32;
                const auto path = folder_.write(
                    "run.bin", encoded(wave, whole ? counts : 1.5, whole ? offset : 0, layout));
                const RawLayout found = guessed(path);
                QVERIFY2(found == layout, text_of(layout) + " taken for " + text_of(found));
            }
        }
    }

    void wide_counts_and_small_units_are_found() {
        const SimulatedDecay wave = decay(5300, 0.3);
        for (const bool big : {false, true}) {
            RawLayout layout{.type = RawType::i32, .big_endian = big};
            QCOMPARE(guessed(folder_.write("24.bin", encoded(wave, 8e6, 0, layout))), layout);
            QCOMPARE(guessed(folder_.write("32.bin", encoded(wave, 1.5e9, 0, layout))), layout);
            layout.type = RawType::f32;
            QCOMPARE(guessed(folder_.write("m.bin", encoded(wave, 1e-9, 0, layout))), layout);
            QCOMPARE(guessed(folder_.write("k.bin", encoded(wave, 3000, 100, layout))), layout);
        }
    }

    void a_header_is_skipped_data() {
        QTest::addColumn<QByteArray>("header");
        QByteArray text("Board E-502, channels 2, rate 33333.33 Hz, range 10 V, gain 1\r\n");
        QTest::newRow("text, then zeros") << text.leftJustified(512, '\0');
        QTest::newRow("text, then blanks") << text.leftJustified(256, ' ');
        QTest::newRow("text alone") << text.left(52);
        std::mt19937 random(4);
        QByteArray noise;
        for (int i = 0; i < 1024; ++i) {
            noise += static_cast<char>(random() & 0xFF);
        }
        QTest::newRow("noise") << noise;
        QTest::newRow("44 bytes") << noise.left(44);
        QTest::newRow("4 KiB") << noise.repeated(4);
    }
    void a_header_is_skipped() {
        QFETCH(QByteArray, header);
        const SimulatedDecay wave = decay(5300, 0.3);
        for (const RawType type : {RawType::i16, RawType::i32, RawType::f32, RawType::f64}) {
            for (const bool big : {false, true}) {
                RawLayout layout{.type = type, .big_endian = big, .skip_bytes = header.size()};
                const bool whole = type == RawType::i16 || type == RawType::i32;
                const auto path = folder_.write(
                    "run.bin", header.toStdString() + encoded(wave, whole ? 9000 : 1.5, 0, layout));
                RawLayout found = guessed(path);
                // Where the length is not round, the last number may pass for a sample.
                const auto width = static_cast<std::int64_t>(encoded(0, layout).size());
                if (header.size() % 64 != 0 && found.skip_bytes + width == layout.skip_bytes) {
                    found.skip_bytes = layout.skip_bytes;
                }
                QVERIFY2(found == layout, text_of(layout) + " taken for " + text_of(found));
            }
        }
    }

    void noise_and_silence_have_no_layout() {
        std::mt19937 random(5);
        std::string noise;
        for (int i = 0; i < 100000; ++i) {
            noise += static_cast<char>(random() & 0xFF);
        }
        QCOMPARE(guessed(folder_.write("noise.bin", noise)).channels, 0);
        QCOMPARE(guessed(folder_.write("zero.bin", std::string(50000, '\0'))).channels, 0);
        QCOMPARE(guessed(folder_.write("short.bin", "abc")).channels, 0);
    }
};

VYBEG_TEST(TestRawGuess)

}  // namespace test_raw_guess

#include "test_raw_guess.moc"
