#include "core/output/npy_head.h"

#include "core/output/raw_bytes.h"

#include <cstdint>

namespace vybeg {

std::string npy_head(std::string_view type, std::string_view shape) {
    std::string dictionary = "{'descr': '";
    dictionary.append(type).append("', 'fortran_order': False, 'shape': (");
    dictionary.append(shape).append("), }");
    // Magic (6), version (2), length (2), dictionary and line feed fill a multiple of 64 bytes.
    dictionary.append(63 - (10 + dictionary.size()) % 64, ' ');
    dictionary += '\n';
    std::string head = "\x93NUMPY";
    head += std::string_view("\x01\x00", 2);
    append_bytes(head, static_cast<std::uint16_t>(dictionary.size()));
    return head + dictionary;
}

}  // namespace vybeg
