// Archives read by Python's zipfile and by the program itself, with and without ZIP64 fields.
#include "core/output/array_files.h"
#include "core/recording/bytes/file_bytes.h"
#include "core/recording/bytes/packed_parts.h"
#include "tests/core/recording/python_script.h"
#include "tests/test_registry.h"

#include <QtTest>

#include <zlib.h>

namespace test_stored_zip {

using namespace vybeg;
using namespace vybeg::test;

class TestStoredZip : public QObject {
    Q_OBJECT

    QTemporaryDir folder_;

private slots:
    void an_archive_holds_its_members_data() {
        QTest::addColumn<quint64>("most_of_32_bits");
        QTest::newRow("32 bits") << quint64{0xFFFFFFFE};
        QTest::newRow("a size beyond them") << quint64{5000};
        QTest::newRow("places beyond them") << quint64{30000};  // the sum of two members
        QTest::newRow("everything beyond them") << quint64{10};
    }

    void an_archive_holds_its_members() {
        QFETCH(quint64, most_of_32_bits);
        const auto path = folder_.filePath("a.zip").toStdString();
        auto file = OutputFile::create(path, {});
        QVERIFY(file);
        StoredZip zip(*file, most_of_32_bits);
        const std::vector<std::pair<std::string, std::string>> members{
            {"a.npy", std::string(20000, 'a')},
            {"запись.npy", "short"},
            {"empty.npy", ""},
            {"b.npy", std::string(20000, 'b')},
            {"c.npy", std::string(3000, 'c')}};
        for (const auto& [name, content] : members) {
            const auto crc = static_cast<std::uint32_t>(
                crc32_z(0, reinterpret_cast<const Bytef*>(content.data()), content.size()));
            QVERIFY(zip.begin(name, content.size(), crc));
            QVERIFY(file->write(content));
        }
        QVERIFY(zip.finish());
        QVERIFY(file->commit());
        run_python(folder_.path().toStdString(), R"(
import zipfile
z = zipfile.ZipFile('a.zip')
assert z.testzip() is None
assert z.namelist() == ['a.npy', 'запись.npy', 'empty.npy', 'b.npy', 'c.npy'], z.namelist()
assert [z.read(n) for n in z.namelist()] == [b'a' * 20000, b'short', b'', b'b' * 20000, b'c' * 3000]
)");
        const auto bytes = FileBytes::open(path);
        QVERIFY(bytes);
        const auto found = zip_members(**bytes);
        QVERIFY(found);
        QCOMPARE(found->size(), members.size());
        for (std::size_t k = 0; k < members.size(); ++k) {
            QCOMPARE((*found)[k].name, members[k].first);
            const auto content = zip_content(*bytes, (*found)[k]);
            QVERIFY(content);
            QCOMPARE((*content)->size(), static_cast<std::int64_t>(members[k].second.size()));
        }
    }
};

VYBEG_TEST(TestStoredZip)

}  // namespace test_stored_zip

#include "test_stored_zip.moc"
