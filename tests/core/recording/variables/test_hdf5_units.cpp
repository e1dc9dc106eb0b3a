// Units, rates and scales that the attributes of HDF5 files name.
#include "tests/closeness.h"
#include "tests/core/recording/demo_files.h"
#include "tests/test_registry.h"

namespace test_hdf5_units {

using namespace vybeg;
using namespace vybeg::test;

namespace {

const char* const script = R"(
import h5py
counts = lambda x: np.round(1000 * x)
def save(name, write, **options):
    with h5py.File(name, 'w', **options) as f:
        write(f)
def units(other, per_volt):
    def write(f):
        f.create_dataset('C', data=c).attrs['unit'] = 'V'
        f.create_dataset('D', data=per_volt * d).attrs['UNIT'] = other
        f['fs'] = fs / 1000
        f['fs'].attrs['units'] = 'kHz'
    return write
save('millivolts.h5', units('mV', 1000))
save('accelerations.h5', units('m/s^2', 1))
def step_in_ms(f):
    f['C'], f['D'], f['dt'] = c, d, 1000 / fs
    f['dt'].attrs['units'] = 'ms'
save('step_in_ms.h5', step_in_ms)
def rate_in_khz(f):
    f['C'], f['D'] = c, d
    f.attrs['sampling_rate'], f.attrs['sampling_rate_unit'] = fs / 1000, 'kHz'
save('rate_in_khz.h5', rate_in_khz)
def two_rates(f):
    for name, x, rate in (('C', c, fs), ('D', d, 33000.0)):
        f.create_dataset(name, data=x).attrs['fs'] = rate
save('two_rates.h5', two_rates)
def netcdf(f):
    f.create_dataset('C', data=counts(c).astype('i2')).attrs['scale_factor'] = 1e-3
    f.create_dataset('D', data=counts(d).astype('i2')).attrs['scale_factor'] = 2e-3
    f['fs'] = fs
save('netcdf.h5', netcdf)
)";

}  // namespace

class TestHdf5Units : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() {
        demo_ = demo_second();
        write_with_python(folder_, demo_, script);
    }

    void d_comes_in_the_unit_of_c() {
        const Recording recording = opened(folder_.file("millivolts.h5"));
        VYBEG_CLOSE(recording.rate_hz, 33333, 1e-9);
        const Diagnostic* converted = find(recording, DiagnosticKind::unit_converted);
        QVERIFY(converted);
        QCOMPARE(converted->args, (std::vector<MessageArg>{"D", "mV", "V"}));
        const Samples samples = read_all(recording);
        for (std::size_t i = 0; i < demo_.d.size(); ++i) {
            VYBEG_WITHIN(samples.d[i], demo_.d[i], 1e-15);
        }
        QCOMPARE(samples.c, demo_.c);
        QVERIFY(find(opened(folder_.file("accelerations.h5")), DiagnosticKind::units_differ));
    }

    void a_rate_may_have_a_unit_data() {
        QTest::addColumn<QString>("file");
        QTest::newRow("a step in ms") << "step_in_ms.h5";
        QTest::newRow("a rate in kHz") << "rate_in_khz.h5";
    }

    void a_rate_may_have_a_unit() {
        QFETCH(QString, file);
        const Recording recording = opened(folder_.file(file.toStdString()));
        VYBEG_CLOSE(recording.rate_hz, 33333, 1e-8);
    }

    void what_contradicts_itself_or_is_scaled_is_refused_data() {
        QTest::addColumn<QString>("reason");
        QTest::newRow("two_rates.h5")
            << "two sample rates, 33333 and 33000 Hz (--variables C,D,RATE tells which holds)";
        QTest::newRow("netcdf.h5") << "values for scale_factor and add_offset (/C)";
    }

    void what_contradicts_itself_or_is_scaled_is_refused() {
        QFETCH(QString, reason);
        const auto refused = open(folder_.file(QTest::currentDataTag()));
        QVERIFY(!refused);
        QVERIFY(refused.error().code == ErrorCode::format_unsupported);
        QCOMPARE(QString::fromStdString(english(refused.error().args[1])), reason);
    }

private:
    Folder folder_;
    Samples demo_;
};

VYBEG_TEST(TestHdf5Units)

}  // namespace test_hdf5_units

#include "test_hdf5_units.moc"
