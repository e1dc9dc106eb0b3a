// Damaged MAT and HDF5 files: whatever libhdf5 does on them, the program gets an error or a
// recording.
#include "core/recording/bytes/number_type.h"
#include "tests/closeness.h"
#include "tests/core/recording/damaged_files.h"
#include "tests/core/recording/demo_files.h"
#include "tests/test_registry.h"

namespace test_damaged_libraries {

using namespace vybeg;
using namespace vybeg::test;

namespace {

constexpr std::size_t frames = 300;

const char* const script = R"(
import scipy.io as sio
import h5py
run = {'C': c, 'D': d, 'fs': fs, 's': {'x': np.arange(9.0)}, 'e': np.array(['a', 3.0], object)}
flat = {'C': c, 'D': d, 'fs': fs, 'x': np.arange(9.0)}
sio.savemat('v4', flat, format='4')
sio.savemat('v5', run)
sio.savemat('v7', run, do_compression=True)
with h5py.File('hdf5', 'w') as f:
    for name, x in (('C', c), ('D', d)):
        f.create_dataset('run/' + name, data=x, chunks=(100,), compression='gzip',
                         fletcher32=True).attrs['unit'] = 'V'
    f['run'].attrs['fs'] = fs
with h5py.File('hdf5_latest', 'w', libver='latest') as f:
    f['C'], f['D'], f['fs'] = c, d, fs
)";

}  // namespace

class TestDamagedLibraries : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { write_with_python(folder_, wave(frames), script); }

    void a_file_cut_anywhere_is_an_error_data() {
        QTest::addColumn<QString>("format");
        for (const char* format : {"v4", "v5", "v7", "hdf5", "hdf5_latest"}) {
            QTest::newRow(format) << format;
        }
    }

    void a_file_cut_anywhere_is_an_error() {
        QFETCH(QString, format);
        const std::string bytes = bytes_of(folder_.file(format.toStdString()));
        DamageCount count;
        for (std::size_t length = 1; length < bytes.size(); length += 1 + bytes.size() / 200) {
            try_damaged(folder_.write("cut", std::string_view(bytes).substr(0, length)), {}, frames,
                        count);
        }
        // Only a level 4 or 5 that ends exactly behind a variable is whole as it is.
        VYBEG_MORE(count.refused, 150);
        VYBEG_AT_MOST(count.read + count.unreadable, 3);
        QCOMPARE(count.wrong_status, 0);
        VYBEG_LESS(count.slowest_ms, 2500);
    }

    void wrong_bits_do_no_harm_data() {
        QTest::addColumn<QString>("format");
        QTest::addColumn<int>("files");  // 2000 of MAT and of HDF5
        QTest::addColumn<int>("head");   // bytes at the beginning that may be hit
        QTest::addColumn<int>("tail");   // bytes at the end that may
        QTest::newRow("v4") << "v4" << 500 << 100 << 150;
        QTest::newRow("v5") << "v5" << 800 << 300 << 800;
        QTest::newRow("v7") << "v7" << 700 << 100000 << 0;
        QTest::newRow("hdf5") << "hdf5" << 1000 << 4000 << 600;
        QTest::newRow("hdf5_latest") << "hdf5_latest" << 1000 << 2000 << 600;
    }

    void wrong_bits_do_no_harm() {
        QFETCH(QString, format);
        const std::string bytes = bytes_of(folder_.file(format.toStdString()));
        QFETCH(int, files);
        QFETCH(int, head);
        QFETCH(int, tail);
        const DamageCount count =
            flip_bits(folder_, bytes, static_cast<std::size_t>(head),
                      static_cast<std::size_t>(tail), {}, 100 * frames, files);
        qInfo("%d refused, %d unreadable, %d read, slowest %lld ms", count.refused,
              count.unreadable, count.read, count.slowest_ms);
        VYBEG_MORE(count.refused, files / 10);
        VYBEG_MORE(count.read, files / 50);
        QCOMPARE(count.wrong_status, 0);
        QCOMPARE(count.too_long, 0);
        // Two seconds for the list of variables, and two for samples.
        VYBEG_LESS(count.slowest_ms, 4500);
    }

    void a_variable_of_4_gigabytes_takes_no_memory() {
        std::string bytes = bytes_of(folder_.file("v4"));
        const auto rows = store<std::int32_t>(1 << 29, false);
        bytes.replace(4, 4, rows);
        const auto recording = open(folder_.write("huge", bytes));
        QVERIFY(!recording);
        QCOMPARE(recording.error().code, ErrorCode::format_damaged);
    }

private:
    Folder folder_;
};

VYBEG_TEST(TestDamagedLibraries, long, unsanitized)

}  // namespace test_damaged_libraries

#include "test_damaged_libraries.moc"
