#include "core/recording/bytes/number_type.h"

#include "core/base/message_arg.h"

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
    switch (type) {
        case NumberType::i8: return VYBEG_MESSAGE("Format", "8 bit integer");
        case NumberType::u8: return VYBEG_MESSAGE("Format", "8 bit unsigned integer");
        case NumberType::i16: return VYBEG_MESSAGE("Format", "16 bit integer");
        case NumberType::u16: return VYBEG_MESSAGE("Format", "16 bit unsigned integer");
        case NumberType::f16: return VYBEG_MESSAGE("Format", "16 bit float");
        case NumberType::i24: return VYBEG_MESSAGE("Format", "24 bit integer");
        case NumberType::i32: return VYBEG_MESSAGE("Format", "32 bit integer");
        case NumberType::u32: return VYBEG_MESSAGE("Format", "32 bit unsigned integer");
        case NumberType::f32: return VYBEG_MESSAGE("Format", "32 bit float");
        case NumberType::i64: return VYBEG_MESSAGE("Format", "64 bit integer");
        case NumberType::u64: return VYBEG_MESSAGE("Format", "64 bit unsigned integer");
        case NumberType::f64: return VYBEG_MESSAGE("Format", "64 bit float");
    }
    return {};
}

}  // namespace vybeg
