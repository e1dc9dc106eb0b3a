#include "tests/closeness.h"
#include "tests/core/recording/arrays/tdms_file.h"
#include "tests/core/recording/demo_files.h"
#include "tests/core/recording/text/uff_file.h"
#include "tests/test_registry.h"

namespace test_saved_decay {

using namespace vybeg;
using namespace vybeg::test;

// One second of the demonstration decay in every format that is read without a library: its samples
// come back to the format's own rounding, and so does its rate.
class TestSavedDecay : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() {
        write_with_python(folder_, decay_, R"(
np.save('double.npy', np.stack([c, d], axis=1))
np.save('rows.npy', np.stack([c, d]))
np.save('single.npy', np.stack([c, d], axis=1).astype('>f4'))
np.save('counts.npy', np.asfortranarray(np.round(1000 * np.stack([c, d], axis=1)).astype('i2')))
np.savez('stored.npz', c=c, d=d, fs=fs)
np.savez_compressed('packed.npz', xy=np.stack([c, d], axis=1), fs=fs)
np.savez_compressed('single.npz', c=c.astype('f4'), d=d.astype('f4'), fs=np.float32(fs))
)");
        for (const bool interleave : {false, true}) {
            const Tdms t{interleave};  // one of each byte order
            const std::string metadata =
                t.metadata({t.object(path_c, t.values(tds_f64, decay_.c.size()),
                                     {t.real("wf_increment", 1 / 33333.0)}),
                            t.object(path_d, t.values(tds_f64, decay_.c.size()))});
            const std::string raw = interleave ? t.raw<double>(interleaved(decay_.c, decay_.d))
                                               : t.raw<double>(decay_.c) + t.raw<double>(decay_.d);
            folder_.write(
                interleave ? "interleaved.tdms" : "contiguous.tdms",
                t.segment(first_segment | (interleave ? toc_interleaved : 0), metadata, raw));
        }
        UffText text;
        text.step_s = 1 / 33333.0;
        folder_.write("single.uff", uff58(decay_.c, text) + uff58(decay_.d, text));
        text.doubles = true;
        folder_.write("double.uff", uff58(decay_.c, text) + uff58(decay_.d, text));
    }

    void samples_come_back_to_the_rounding_of_the_format_data() {
        QTest::addColumn<QString>("name");
        QTest::addColumn<double>("rounding");  // largest error of a sample, relative to the sample
        QTest::addColumn<double>("scale");     // of the samples in the file
        QTest::addColumn<double>("rate_rounding");
        const auto add = [](const char* name, double rounding, double scale = 1,
                            double rate_rounding = 0) {
            QTest::newRow(name) << QString(name) << rounding << scale << rate_rounding;
        };
        constexpr double single = 6e-8;  // 2^-24
        constexpr double e13_5 = 5e-6;   // half a unit of the sixth digit, of 1.00000
        constexpr double e20_12 = 5e-13;
        add("double.npy", 0);
        add("rows.npy", 0);
        add("single.npy", single);
        add("counts.npy", -1, 1000);
        add("stored.npz", 0);
        add("packed.npz", 0);
        add("single.npz", single);
        add("contiguous.tdms", 0, 1, 1e-15);
        add("interleaved.tdms", 0, 1, 1e-15);
        add("single.uff", e13_5, 1, e13_5);
        add("double.uff", e20_12, 1, e13_5);
    }

    void samples_come_back_to_the_rounding_of_the_format() {
        QFETCH(QString, name);
        QFETCH(double, rounding);
        QFETCH(double, scale);
        QFETCH(double, rate_rounding);
        OpenOptions options;
        if (name.endsWith(".npy")) {
            options.rate_hz = 33333;
        }
        const Recording recording = opened(folder_.file(name.toStdString()), options);
        QCOMPARE(recording.frames(), static_cast<std::int64_t>(decay_.c.size()));
        QVERIFY(recording.diagnostics.empty());
        VYBEG_WITHIN(recording.rate_hz / 33333, 1, rate_rounding);
        const Samples read = read_all(recording);
        int wrong = 0;
        const auto compare = [&](const std::vector<double>& found,
                                 const std::vector<double>& written) {
            for (std::size_t i = 0; i < written.size(); ++i) {
                // Whole counts are half a count wrong at the most.
                const double allowed = rounding < 0 ? 0.5 : rounding * std::abs(scale * written[i]);
                wrong += std::abs(found[i] - scale * written[i]) <= allowed ? 0 : 1;
            }
        };
        compare(read.c, decay_.c);
        compare(read.d, decay_.d);
        QCOMPARE(wrong, 0);
    }

private:
    Folder folder_;
    Samples decay_ = demo_second();
};

VYBEG_TEST(TestSavedDecay)

}  // namespace test_saved_decay

#include "test_saved_decay.moc"
