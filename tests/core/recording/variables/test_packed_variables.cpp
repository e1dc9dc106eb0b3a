// Compressed variables of MAT 5 are unpacked once on the way from start to end: counted in bytes
// that are read of the file, not in time.
#include "tests/closeness.h"
#include "tests/core/recording/python_script.h"
#include "tests/core/recording/recording_files.h"
#include "tests/test_registry.h"

namespace test_packed_variables {

using namespace vybeg;
using namespace vybeg::test;

namespace {

constexpr std::int64_t frames = 3000000;
constexpr std::int64_t at_once = 1 << 16;

// Bytes that this process has read until now.
std::int64_t bytes_read() {
    std::ifstream stream("/proc/self/io");
    std::string name;
    std::int64_t count = 0;
    stream >> name >> count;
    return name == "rchar:" ? count : -1;
}

OpenOptions at_any_rate() {
    OpenOptions options{.rate_hz = 1000};
    return options;
}

}  // namespace

class TestPackedVariables : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() {
        run_python(folder_.file(""), R"(
import scipy.io as sio
random = np.random.default_rng(5)
c, d = random.integers(0, 30000, (2, 3000000)).astype('i2')
sio.savemat('vectors', {'C': c, 'D': d}, do_compression=True)
sio.savemat('columns', {'run': np.stack([c, d], 1)}, do_compression=True)
sio.savemat('rows', {'run': np.stack([c, d], 0)}, do_compression=True)
sio.savemat('struct', {'run': {'C': c, 'D': d}}, do_compression=True)
c.astype('f8').tofile('c')
d.astype('f8').tofile('d')
)");
    }

    void a_pass_unpacks_each_byte_once_data() {
        QTest::addColumn<double>("passes");  // over the whole file, C and D together
        QTest::newRow("vectors") << 1.0;
        // D stands behind C in the same packed bytes and is read with a decoder of its own. Opening
        // has looked at the first samples of channels without names, and that of D goes on from
        // there.
        QTest::newRow("columns") << 1.0;
        QTest::newRow("struct") << 1.5;
        // Side by side, and read together.
        QTest::newRow("rows") << 1.0;
    }

    void a_pass_unpacks_each_byte_once() {
        QFETCH(double, passes);
        const auto path = folder_.file(QTest::currentDataTag());
        const Recording recording = opened(path, at_any_rate());
        QCOMPARE(recording.frames(), frames);
        Samples samples;
        const std::int64_t before = bytes_read();
        for (std::int64_t at = 0; at < frames; at += at_once) {
            const Samples part = read(*recording.source, at, std::min(at_once, frames - at));
            samples.c.insert(samples.c.end(), part.c.begin(), part.c.end());
            samples.d.insert(samples.d.end(), part.d.begin(), part.d.end());
        }
        const auto read = static_cast<double>(bytes_read() - before);
        const auto size = static_cast<double>(std::filesystem::file_size(path));
        VYBEG_MORE(read / size, 0.9 * passes);
        VYBEG_LESS(read / size, 1.15 * passes);
        for (const auto& [name, found] : {std::pair("c", &samples.c), {"d", &samples.d}}) {
            const std::string bytes = bytes_of(folder_.file(name));
            QCOMPARE(bytes.size(), found->size() * sizeof(double));
            QVERIFY(std::memcmp(bytes.data(), found->data(), bytes.size()) == 0);
        }
    }

    void packed_bytes_that_are_wrong_are_an_error() {
        const std::string bytes = bytes_of(folder_.file("vectors"));
        // In the middle of C: its beginning can still be read, and D.
        std::string damaged = bytes;
        damaged.replace(bytes.size() / 4, 4096, 4096, '\xFF');
        const auto path = folder_.write("damaged", damaged);
        OpenOptions options = at_any_rate();
        const Recording recording = opened(path, options);
        std::vector<double> c(1000), d(1000);
        QVERIFY(recording.source->read(0, c, d));
        const Status end = recording.source->read(frames - 1000, c, d);
        QVERIFY(!end);
        QCOMPARE(end.error().code, ErrorCode::format_damaged);
        options.variables = {"D", "D"};
        QVERIFY(opened(path, options).source->read(frames - 1000, c, d));
    }

private:
    Folder folder_;
};

VYBEG_TEST(TestPackedVariables)

}  // namespace test_packed_variables

#include "test_packed_variables.moc"
