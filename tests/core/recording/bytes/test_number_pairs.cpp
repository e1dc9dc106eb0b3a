#include "core/recording/bytes/number_type.h"
#include "tests/core/recording/source_reading.h"
#include "tests/test_registry.h"

namespace test_number_pairs {

using namespace vybeg;
using namespace vybeg::test;

// Pairs are decoded by code of their own, several at once and for each kind of processor another.
class TestNumberPairs : public QObject {
    Q_OBJECT

private slots:
    void pairs_are_what_their_columns_are_data() {
        QTest::addColumn<int>("type");
        for (const NumberType type :
             {NumberType::i8, NumberType::u8, NumberType::i16, NumberType::u16, NumberType::i24,
              NumberType::i32, NumberType::u32, NumberType::i64, NumberType::u64, NumberType::f32,
              NumberType::f64}) {
            QTest::newRow(name_of(type).c_str()) << static_cast<int>(type);
        }
    }

    void pairs_are_what_their_columns_are() {
        QFETCH(int, type);
        const auto number = static_cast<NumberType>(type);
        const std::int64_t width = bytes_of(number);
        std::mt19937_64 random(11);
        for (const Scale scale :
             {Scale{}, Scale{0x1p-15, 0}, Scale{-0.3, 0.7}, Scale{1e300, 0}, Scale{1, 1e308}}) {
            for (const bool big_endian : {false, true}) {
                for (std::size_t count = 0; count < 40; ++count) {
                    // Exactly as many bytes as there are, at an odd place; floats of all kinds, NaN
                    // and infinite ones among them.
                    std::vector<char> bytes(1 + 2 * count * static_cast<std::size_t>(width));
                    for (char& byte : bytes) {
                        byte = random() % 4 == 0 ? '\xFF' : static_cast<char>(random());
                    }
                    const char* const at = bytes.data() + 1;
                    std::vector<double> left(count), right(count), c(count), d(count);
                    decode_pairs(number, big_endian, at, scale, left, right);
                    decode(number, big_endian, at, 2 * width, scale, c);
                    decode(number, big_endian, at + width, 2 * width, scale, d);
                    QVERIFY(same_numbers(left, c) && same_numbers(right, d));
                }
            }
        }
    }

    void known_numbers_of_24_bits() {
        const std::string bytes(
            "\x01\x00\x00\xFF\xFF\xFF\x00\x00\x80\xFF\xFF\x7F\x00\x01\x00\x00\x00\x01"
            "\x02\x00\x00\xFE\xFF\xFF\x03\x00\x00\xFD\xFF\xFF",
            30);
        std::vector<double> left(5), right(5);
        decode_pairs(NumberType::i24, false, bytes.data(), {}, left, right);
        QCOMPARE(left, (std::vector<double>{1, -8388608, 256, 2, 3}));
        QCOMPARE(right, (std::vector<double>{-1, 8388607, 65536, -2, -3}));
    }
};

VYBEG_TEST(TestNumberPairs)

}  // namespace test_number_pairs

#include "test_number_pairs.moc"
