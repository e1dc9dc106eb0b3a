#include "core/recording/bytes/number_type.h"
#include "tests/closeness.h"
#include "tests/core/recording/damaged_files.h"
#include "tests/core/recording/python_script.h"
#include "tests/core/recording/recording_files.h"
#include "tests/test_registry.h"

#include <array>
#include <thread>

namespace test_npz_reader {

using namespace vybeg;
using namespace vybeg::test;

namespace {

constexpr int frames = 300000;  // more than the distance of the states that are remembered

const OpenOptions with_rate{.rate_hz = 20.0, .raw = std::nullopt};

OpenOptions named(std::vector<std::string> names) {
    OpenOptions options{.variables = std::move(names)};
    return options;
}

// What the script in initTestCase() writes.
Samples written() {
    Samples samples;
    for (int i = 0; i < frames; ++i) {
        samples.c.push_back(7 * i % 1000 - 500);
        samples.d.push_back(i % 601 - 300);
    }
    return samples;
}

}  // namespace

class TestNpzReader : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() {
        run_python(folder_.file(""), R"(
import zipfile
i = np.arange(300000)
c, d = (7 * i % 1000 - 500).astype('f8'), (i % 601 - 300).astype('f8')
for kind, save in (('stored', np.savez), ('deflated', np.savez_compressed)):
    pair = np.stack([c, d], axis=1)
    save(kind + '-vectors', c=c, d=d, fs=20.0)
    save(kind + '-big', c=c.astype('>i2'), d=d.astype('>i4'), fs=np.float32(20))
    save(kind + '-columns', pair, fs=20)
    save(kind + '-fortran', xy=np.asfortranarray(pair), fs=np.array([20]))
    save(kind + '-rows', xy=pair.T.copy(), fs=20)
s = i[:1000]
few = dict(c=c[:1000], d=d[:1000])
np.savez('rate', rate=20, **few)
np.savez('step', dt=0.05, **few)
np.savez('times', t=s * 0.05, **few)
np.savez('milliseconds', t_ms=s * 50.0, **few)
np.savez('no-rate', temperature=20.0, **few)
np.savez('uneven', t=s * 0.05 + 0.01 * np.sin(s / 20), c=np.cos(s / 20), d=np.sin(s / 20))
np.savez('several', Temp=c[:10], a=c[:1000], long=np.stack([c, d, -c], 1)[:5000], b=d[:1000],
         hz=np.float64(50), x=c[:1000] + 1, fs=20)
np.savez('other', words=np.array(['a', 'b']), z=np.zeros((10, 2), 'c16'), o=np.zeros((10, 3, 2)))
np.savez('one', c=c[:1000], fs=20)
np.savez('crossed', t=s * 0.05, S_D=d[:1000], b=c[:1000], S_C=c[:1000])
np.savez('two-rates', fs=48.0, t=s * 0.05, **few)
np.savez('counted', fs=20.0, t=s * 1.0, **few)
np.savez('small', c=c[:40], d=d[:40], fs=20.0)
np.savez_compressed('small-deflated', c=c[:40], d=d[:40], fs=20.0)
with zipfile.ZipFile('book.xlsx', 'w') as archive:
    archive.writestr('xl/workbook.xml', '<workbook/>')
with zipfile.ZipFile('texts.zip', 'w') as archive:
    archive.writestr('note.txt', 'hello')
for method, name in ((zipfile.ZIP_BZIP2, 'bzip2'), (zipfile.ZIP_LZMA, 'lzma')):
    with zipfile.ZipFile(name + '.npz', 'w', method) as archive:
        np.save('c', c[:100])
        archive.write('c.npy')
with zipfile.ZipFile('bomb.npz', 'w', zipfile.ZIP_DEFLATED) as archive:
    with archive.open('xy.npy', 'w', force_zip64=True) as file:
        np.lib.format.write_array_header_1_0(
            file, {'descr': '<f8', 'fortran_order': False, 'shape': (1 << 25, 2)})
        for _ in range(64):
            file.write(bytes(1 << 23))
    with archive.open('fs.npy', 'w') as file:
        np.lib.format.write_array(file, np.float64(20))
)");
    }

    void stored_and_deflated_arrays_of_any_layout_come_back_data() {
        QTest::addColumn<QString>("name");
        QTest::addColumn<QString>("type");
        for (const char* kind : {"stored", "deflated"}) {
            for (const char* layout : {"vectors", "big", "columns", "fortran", "rows"}) {
                const QString name = QString("%1-%2.npz").arg(kind, layout);
                QTest::newRow(qPrintable(name))
                    << name << (layout[0] == 'b' ? "16 bit integer" : "64 bit float");
            }
        }
    }

    void stored_and_deflated_arrays_of_any_layout_come_back() {
        QFETCH(QString, name);
        QFETCH(QString, type);
        const Recording recording = opened(folder_.file(name.toStdString()));
        QCOMPARE(QString::fromStdString(english(recording.format)),
                 "NPZ, " + type + ", 2 channels");
        QCOMPARE(recording.rate_hz, 20.0);
        QCOMPARE(recording.rate_from, RateOrigin::file);
        const Samples read = read_all(recording);
        QCOMPARE(read, written());
        if (name.contains("vectors")) {
            QCOMPARE(recording.channels[0].name, std::string("c"));
            QCOMPARE(recording.channels[1].name, std::string("d"));
        }
    }

    void deflated_samples_are_the_same_however_they_are_read_data() {
        QTest::addColumn<QString>("name");
        QTest::newRow("vectors") << "deflated-vectors.npz";
        QTest::newRow("side by side") << "deflated-columns.npz";
        QTest::newRow("one after the other") << "deflated-fortran.npz";
    }

    void deflated_samples_are_the_same_however_they_are_read() {
        QFETCH(QString, name);
        const Recording recording = opened(folder_.file(name.toStdString()));
        // From the end to the start, and then anywhere.
        for (std::int64_t first = frames - 10000; first >= 0; first -= 30000) {
            const Samples part = read(*recording.source, first, 10000);
            QVERIFY(std::equal(part.c.begin(), part.c.end(), written().c.begin() + first));
            QVERIFY(std::equal(part.d.begin(), part.d.end(), written().d.begin() + first));
        }
        QVERIFY(same_however_cut(*recording.source, 5000));
    }

    void several_threads_read_the_same_samples() {
        const Recording recording = opened(folder_.file("deflated-columns.npz"));
        const Samples all = written();
        std::array<int, 4> wrong{};
        std::vector<std::thread> threads;
        for (std::size_t thread = 0; thread < wrong.size(); ++thread) {
            threads.emplace_back([&, thread] {
                for (std::int64_t first = 0; first < frames; first += 60000) {
                    const std::int64_t at =
                        (first + 75000 * static_cast<std::int64_t>(thread)) % (frames - 1000);
                    const Samples part = read(*recording.source, at, 1000);
                    wrong[thread] +=
                        part.c.size() == 1000 &&
                                std::equal(part.c.begin(), part.c.end(), all.c.begin() + at)
                            ? 0
                            : 1;
                }
            });
        }
        for (std::thread& thread : threads) {
            thread.join();
        }
        QCOMPARE(wrong, (std::array<int, 4>{}));
    }

    void the_rate_comes_from_a_number_or_from_times_data() {
        QTest::addColumn<QString>("name");
        QTest::addColumn<int>("origin");
        QTest::newRow("rate") << "rate.npz" << static_cast<int>(RateOrigin::file);
        QTest::newRow("step") << "step.npz" << static_cast<int>(RateOrigin::file);
        QTest::newRow("times") << "times.npz" << static_cast<int>(RateOrigin::time_column);
        QTest::newRow("milliseconds")
            << "milliseconds.npz" << static_cast<int>(RateOrigin::time_column);
        QTest::newRow("number beside what counts the rows")
            << "counted.npz" << static_cast<int>(RateOrigin::file);
        QTest::newRow("option") << "no-rate.npz" << static_cast<int>(RateOrigin::option);
    }

    void the_rate_comes_from_a_number_or_from_times() {
        QFETCH(QString, name);
        QFETCH(int, origin);
        const Recording recording = opened(folder_.file(name.toStdString()), with_rate);
        VYBEG_CLOSE(recording.rate_hz, 20, 1e-9);
        QCOMPARE(static_cast<int>(recording.rate_from), origin);
        QCOMPARE(recording.channels.size(), 2u);
        QCOMPARE(recording.frames(), 1000);
        QCOMPARE(open(folder_.file("no-rate.npz")).error().code, ErrorCode::rate_unknown);
    }

    void uneven_times_are_brought_onto_a_grid() {
        const Recording recording = opened(folder_.file("uneven.npz"));
        QVERIFY(find(recording, DiagnosticKind::time_uneven));
        QCOMPARE(recording.rate_from, RateOrigin::time_column);
        VYBEG_CLOSE(recording.rate_hz, 20, 0.01);
    }

    void variables_are_chosen_by_name() {
        const auto path = folder_.file("several.npz");
        const Recording pair = opened(path, named({"x", "b"}));
        QCOMPARE(pair.channels[0].name, std::string("x"));
        QCOMPARE(pair.rate_hz, 20.0);
        QCOMPARE(read_all(pair).c[5], written().c[5] + 1);
        QCOMPARE(read_all(pair).d[5], written().d[5]);
        QCOMPARE(opened(path, named({"b", "a", "hz"})).rate_hz, 50.0);
        QCOMPARE(opened(path, named({"long", "", "hz"})).rate_hz, 50.0);
        OpenOptions options = named({"long"});
        options.channel_d = 3;
        const Recording array = opened(path, options);
        QCOMPARE(array.channels.size(), 3u);
        QCOMPARE(read_all(array).d[5], -written().c[5]);
    }

    void variables_named_as_channels_are_these() {
        const Recording recording = opened(folder_.file("crossed.npz"));
        QCOMPARE(recording.channels[0].name, std::string("S_C"));
        QCOMPARE(recording.channels[1].name, std::string("S_D"));
        QCOMPARE(recording.channels[2].name, std::string("b"));
        QCOMPARE(read_all(recording).d[5], written().d[5]);
        QVERIFY(!find(recording, DiagnosticKind::channels_crossed));
        QVERIFY(!find(opened(folder_.file("crossed.npz"), named({"S_D", "S_C", "t"})),
                      DiagnosticKind::channels_crossed));
    }

    void a_name_that_is_not_there_is_an_error() {
        const auto recording = open(folder_.file("several.npz"), named({"a", "none"}));
        QVERIFY(!recording);
        QCOMPARE(recording.error().code, ErrorCode::variable_missing);
        QCOMPARE(recording.error().args,
                 (std::vector<MessageArg>{"none", "Temp, a, long, b, hz, x, fs"}));
    }

    void of_several_the_longest_are_taken() {
        const Recording recording = opened(folder_.file("several.npz"));
        QCOMPARE(recording.channels.size(), 3u);  // those of "long"
        QCOMPARE(recording.frames(), 5000);
    }

    void what_is_not_read_is_refused_by_name_data() {
        QTest::addColumn<QString>("name");
        QTest::addColumn<int>("code");
        QTest::addColumn<QString>("word");
        const int unsupported = static_cast<int>(ErrorCode::format_unsupported);
        QTest::newRow("no arrays") << "texts.zip" << unsupported << "NumPy";
        QTest::newRow("workbook") << "book.xlsx" << unsupported << "sheets of a workbook";
        QTest::newRow("no numbers") << "other.npz" << unsupported << "<U1";
        QTest::newRow("bzip2") << "bzip2.npz" << unsupported << "method 12";
        QTest::newRow("lzma") << "lzma.npz" << unsupported << "method 14";
        QTest::newRow("two rates") << "two-rates.npz" << unsupported << "48 and 20 Hz";
        QTest::newRow("one vector")
            << "one.npz" << static_cast<int>(ErrorCode::too_few_channels) << "1 channel";
    }

    void what_is_not_read_is_refused_by_name() {
        QFETCH(QString, name);
        QFETCH(int, code);
        QFETCH(QString, word);
        const auto recording = open(folder_.file(name.toStdString()), with_rate);
        QVERIFY(!recording);
        const QString sentence = QString::fromStdString(english(recording.error()));
        QVERIFY2(static_cast<int>(recording.error().code) == code, qPrintable(sentence));
        QVERIFY2(sentence.contains(word), qPrintable(sentence));
    }

    void zip64_archives_are_read() {
        // The directory's numbers moved into the ZIP64 fields, and its end record with them.
        const std::string bytes = bytes_of(folder_.file("small.npz"));
        const std::size_t end = bytes.rfind("PK\x05\x06");
        const auto entries = load<std::uint16_t>(bytes.data() + end + 10, false);
        const auto at = load<std::uint32_t>(bytes.data() + end + 16, false);
        std::string directory;
        std::string_view rest = std::string_view(bytes).substr(at);
        for (int i = 0; i < entries; ++i) {
            const std::size_t name = load<std::uint16_t>(rest.data() + 28, false);
            const std::size_t extra = load<std::uint16_t>(rest.data() + 30, false);
            std::string entry(rest.substr(0, 46 + name));
            const auto wide = [&](std::size_t place) {
                return store<std::uint64_t>(load<std::uint32_t>(rest.data() + place, false), false);
            };
            const std::string field = store<std::uint16_t>(1, false) +
                                      store<std::uint16_t>(24, false) + wide(24) + wide(20) +
                                      wide(42);
            for (const std::size_t place : {20, 24, 42}) {
                entry.replace(place, 4, 4, '\xFF');
            }
            entry.replace(30, 2, store(static_cast<std::uint16_t>(field.size()), false));
            directory += entry + field;
            rest.remove_prefix(46 + name + extra);
        }
        const auto number = [](std::uint64_t n) { return store(n, false); };
        const std::string end64 = "PK\x06\x06" + number(44) + std::string(4, '\x2D') +
                                  std::string(8, '\0') + number(entries) + number(entries) +
                                  number(directory.size()) + number(at);
        const std::string locator = std::string("PK\x06\x07\0\0\0\0", 8) +
                                    number(at + directory.size()) + std::string("\1\0\0\0", 4);
        std::string last = bytes.substr(end, 22);
        last.replace(8, 12, 12, '\xFF');
        const auto path =
            folder_.write("zip64.npz", bytes.substr(0, at) + directory + end64 + locator + last);
        const Recording recording = opened(path);
        QCOMPARE(recording.frames(), 40);
        const std::vector<double> whole = written().d;
        QCOMPARE(read_all(recording).d, (std::vector<double>(whole.begin(), whole.begin() + 40)));
    }

    void a_bomb_is_no_recording_of_that_length() {
        // 512 MiB of zeros, honestly declared, in half a megabyte.
        VYBEG_LESS(std::filesystem::file_size(folder_.file("bomb.npz")), 1000000);
        const Recording recording = opened(folder_.file("bomb.npz"));
        QCOMPARE(recording.frames(), std::int64_t{1} << 25);
        QCOMPARE(read(*recording.source, (1 << 25) - 5, 5).d, std::vector<double>(5));
        // A directory that promises more than deflate can pack.
        std::string bytes = bytes_of(folder_.file("small-deflated.npz"));
        const std::size_t entry = bytes.find("PK\x01\x02");
        bytes.replace(entry + 24, 4, store<std::uint32_t>(0x7FFFFFFF, false));
        const auto lied = open(folder_.write("lie.npz", bytes));
        QVERIFY(!lied);
        QCOMPARE(lied.error().code, ErrorCode::format_damaged);
    }

    void wrong_content_is_an_error_and_never_samples() {
        std::string bytes = bytes_of(folder_.file("deflated-vectors.npz"));
        for (const std::size_t at : {std::size_t{20000}, bytes.find("PK\x01\x02") + 16}) {
            std::string damaged = bytes;
            damaged[at] =
                static_cast<char>(damaged[at] ^ 0x10);  // in the packed data, in the checksum
            const auto recording = open(folder_.write("damaged.npz", damaged));
            QVERIFY(recording);
            std::vector<double> c(frames), d(frames);
            const Status status = recording->source->read(0, c, d);
            QVERIFY(!status);
            QCOMPARE(status.error().code, ErrorCode::format_damaged);
            QVERIFY(!recording->source->read(0, c, d));
        }
    }

    void a_file_cut_anywhere_or_with_wrong_bits_does_no_harm_data() {
        QTest::addColumn<QString>("name");
        QTest::newRow("stored") << "small.npz";
        QTest::newRow("deflated") << "small-deflated.npz";
    }

    void a_file_cut_anywhere_or_with_wrong_bits_does_no_harm() {
        QFETCH(QString, name);
        const std::string bytes = bytes_of(folder_.file(name.toStdString()));
        // Deflate packs 1032 bytes into one at the most.
        const auto most = static_cast<std::int64_t>(1032 * bytes.size());
        const DamageCount cut = cut_everywhere(folder_, bytes, {}, most);
        QCOMPARE(cut.refused, static_cast<int>(bytes.size()) - 1);  // the directory is at the end
        QCOMPARE(cut.wrong_status, 0);
        const DamageCount flipped = flip_bits(folder_, bytes, bytes.size(), 0, {}, most);
        QCOMPARE(flipped.wrong_status + flipped.too_long, 0);
        VYBEG_MORE(flipped.read, 200);
        VYBEG_MORE(flipped.refused, 200);
        VYBEG_LESS(std::max(cut.slowest_ms, flipped.slowest_ms), 2000);
    }

    void lengths_of_2_to_the_63_are_damage() {
        const std::string bytes = bytes_of(folder_.file("small.npz"));
        const std::size_t end = bytes.rfind("PK\x05\x06");
        const std::size_t entry = bytes.find("PK\x01\x02");
        for (const std::size_t at : {entry + 20, entry + 42, end + 12, end + 16}) {
            std::string damaged = bytes;
            damaged.replace(at, 4, "\xFE\xFF\xFF\xFF");
            const auto recording = open(folder_.write("long.npz", damaged));
            QVERIFY(!recording);
            QCOMPARE(recording.error().code, ErrorCode::format_damaged);
        }
        // Through the ZIP64 end record.
        for (const std::uint64_t size : {std::uint64_t{1} << 63, ~std::uint64_t{0}}) {
            const auto number = [](std::uint64_t n) { return store(n, false); };
            const std::string end64 =
                "PK\x06\x06" + number(44) + std::string(28, '\0') + number(size) + number(size);
            const std::string locator =
                std::string("PK\x06\x07\0\0\0\0", 8) + number(end) + std::string("\1\0\0\0", 4);
            const auto recording = open(folder_.write(
                "long64.npz", bytes.substr(0, end) + end64 + locator + bytes.substr(end)));
            QVERIFY(!recording);
            QCOMPARE(recording.error().code, ErrorCode::format_damaged);
        }
    }

private:
    Folder folder_;
};

VYBEG_TEST(TestNpzReader, threads)

}  // namespace test_npz_reader

#include "test_npz_reader.moc"
