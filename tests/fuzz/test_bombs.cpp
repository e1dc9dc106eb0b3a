// Small files that stand for much: the readers take no more memory than the file's size and 64 MB,
// and no more than 2 s of processor time.
#include "tests/closeness.h"
#include "tests/core/recording/arrays/tdms_file.h"
#include "tests/core/recording/python_script.h"
#include "tests/core/recording/recording_files.h"
#include "tests/fuzz/heap_peak.h"
#include "tests/fuzz/trial.h"
#include "tests/test_registry.h"

#include <ctime>

namespace test_bombs {

using namespace vybeg::fuzz;
using namespace vybeg::test;

class TestBombs : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() {
        run_python(folder_.file(""), R"(
import zipfile, io, struct
zeros = np.zeros(12500000)
np.savez_compressed('zeros', C=zeros, D=zeros, fs=1.0)
np.savez_compressed('times', t=zeros, C=zeros, D=zeros)
def header(shape):
    file = io.BytesIO()
    np.lib.format.write_array_header_1_0(file, {'descr': '<f8', 'fortran_order': False, 'shape': shape})
    return file.getvalue()
def archive(name, members):
    with zipfile.ZipFile(name, 'w', zipfile.ZIP_DEFLATED) as file:
        for member, content in members:
            file.writestr(member, content)
archive('promise.npz', [('run.npy', header((1 << 40, 2)) + bytes(1000))])
archive('wide.npz', [('run.npy', header((2, 1 << 60)) + bytes(1000))])
archive('nothing.npz', [('run.npy', header((1000, 0))), ('fs.npy', header(()) + bytes(8))])
archive('many.npz', [('%d.npy' % i, header((100,)) + bytes(800)) for i in range(9000)])
# 9000 members that are one and the same: the directory alone is as long as the archive.
data = open('many.npz', 'rb').read()
end = data.rfind(b'PK\x05\x06')
begin = struct.unpack('<I', data[end + 16:end + 20])[0]
entry = data[begin:begin + 46 + len('0.npy')]
same = data[:1000] + 9000 * entry
length = len(same) - 1000
same += struct.pack('<IHHHHIIH', 0x06054b50, 0, 0, 9000, 9000, length, 1000, 0)
open('same.npz', 'wb').write(same)
)");
    }

    void archives_are_neither_unpacked_nor_believed_data() {
        QTest::addColumn<bool>("is_recording");
        QTest::newRow("zeros.npz") << true;
        QTest::newRow("times.npz") << true;
        QTest::newRow("promise.npz") << false;
        QTest::newRow("wide.npz") << false;
        QTest::newRow("nothing.npz") << false;
        QTest::newRow("many.npz") << true;
        QTest::newRow("same.npz") << true;
    }

    void archives_are_neither_unpacked_nor_believed() {
        QFETCH(bool, is_recording);
        const Verdict verdict =
            tried(reader_of("npz"), bytes_of(folder_.file(QTest::currentDataTag())));
        qInfo("%s%.1f MB, %.2f s", verdict.fault.c_str(), 1e-6 * static_cast<double>(held_),
              seconds_);
        QCOMPARE(verdict.fault, std::string());
        QCOMPARE(verdict.outcome == Outcome::read, is_recording);
        VYBEG_LESS(held_, 64 << 20);
        VYBEG_LESS(seconds_, 2);
    }

    void a_table_of_segments_stays_smaller_than_the_file() {
        // One chunk, then two, then one, ...: none of them continues another.
        const Tdms t;
        std::string bytes =
            t.segment(first_segment, both_channels(t, tds_i8, 1), std::string(2, '\1'));
        const std::string one = t.segment(toc_raw, "", std::string(2, '\1'));
        const std::string two = t.segment(toc_raw, "", std::string(4, '\1'));
        const auto with = [&](int pairs) {
            std::string all = bytes;
            for (int i = 0; i < pairs; ++i) {
                all += two + one + one;
            }
            return all;
        };
        const Verdict few = tried(reader_of("tdms"), with(1000));
        QVERIFY(few.outcome == Outcome::read && few.fault.empty());
        const Verdict many = tried(reader_of("tdms"), with(400000));
        qInfo("%.1f MB, %.2f s", 1e-6 * static_cast<double>(held_), seconds_);
        QVERIFY(many.outcome == Outcome::refused && many.fault.empty());
        VYBEG_LESS(held_, 64 << 20);
    }

    void a_jump_of_an_uneven_clock_takes_no_memory() {
        const auto with_jump = [](double jump_s) {
            std::string text = "t,C,D\n";
            for (int i = 0; i < 1000; ++i) {
                const double t = 1e-3 * (i + 0.2 * std::sin(i)) + (i < 500 ? 0 : jump_s);
                text += QByteArray::number(t, 'f', 9).toStdString() + ",1,2\n";
            }
            return text;
        };
        const Verdict plausible = tried(reader_of("text"), with_jump(1000));
        QVERIFY(plausible.outcome == Outcome::read && plausible.fault.empty());
        VYBEG_LESS(held_, 64 << 20);
        const Verdict absurd = tried(reader_of("text"), with_jump(5000));
        QVERIFY(absurd.outcome == Outcome::refused && absurd.fault.empty());
        VYBEG_LESS(held_, 64 << 20);
    }

private:
    Verdict tried(const TryFile& try_file, const std::string& bytes) {
        const std::clock_t start = std::clock();
        start_heap_peak();
        Verdict verdict = try_file(bytes);
        held_ = heap_peak() - static_cast<std::int64_t>(bytes.size());
        seconds_ = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
        return verdict;
    }

    Folder folder_;
    std::int64_t held_ = 0;  // bytes, at most, beyond the file's size
    double seconds_ = 0;
};

VYBEG_TEST(TestBombs)

}  // namespace test_bombs

#include "test_bombs.moc"
