#include "core/recording/bytes/number_type.h"

namespace vybeg {

int bytes_of(NumberType type) {
    switch (type) {
        case NumberType::i8:
        case NumberType::u8: return 1;
        case NumberType::i16:
        case NumberType::u16:
        case NumberType::f16: return 2;
        case NumberType::i24: return 3;
        case NumberType::i32:
        case NumberType::u32:
        case NumberType::f32: return 4;
        case NumberType::i64:
        case NumberType::u64:
        case NumberType::f64: return 8;
    }
    return 0;
}

std::string name_of(NumberType type) {
    const std::string bits = std::to_string(8 * bytes_of(type)) + " bit ";
    switch (type) {
        case NumberType::u8:
        case NumberType::u16:
        case NumberType::u32:
        case NumberType::u64: return bits + "unsigned integer";
        case NumberType::f16:
        case NumberType::f32:
        case NumberType::f64: return bits + "float";
        default: return bits + "integer";
    }
}

}  // namespace vybeg
