#include "core/recording/mat_hdf5/library_file.h"

namespace vybeg {

std::string number_type_text(int bits, bool is_float) {
    return std::to_string(bits) + " bit " + (is_float ? "float" : "integer");
}

std::string dimensions_text(int dimensions) {
    return "an array of " + std::to_string(dimensions) + " dimensions";
}

}  // namespace vybeg
