#include "core/libraries/library_file.h"

namespace vybeg {

std::string number_type_text(int bits, bool is_float) {
    return std::to_string(bits) + " bit " + (is_float ? "float" : "integer");
}

}  // namespace vybeg
