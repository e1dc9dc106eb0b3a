#include "core/recording/mat_hdf5/hdf5_attributes.h"

#include "core/base/plain_text.h"
#include "core/recording/samples/vocabulary.h"

#include <algorithm>
#include <array>

namespace vybeg {
namespace {

constexpr int most_attributes = 1000;
constexpr std::size_t most_text_bytes = 256;

std::string name_of(hid_t attribute) {
    std::array<char, most_text_bytes> name{};
    H5Aget_name(attribute, name.size(), name.data());
    return name.data();
}

bool is_single(hid_t attribute) {
    const Hdf5Handle space(H5Aget_space(attribute));
    return space && H5Sget_simple_extent_npoints(space.get()) == 1;
}

std::optional<double> number_of(hid_t attribute) {
    const Hdf5Handle type(H5Aget_type(attribute));
    const H5T_class_t kind = type ? H5Tget_class(type.get()) : H5T_NO_CLASS;
    double value = 0;
    if ((kind != H5T_INTEGER && kind != H5T_FLOAT) || !is_single(attribute) ||
        H5Aread(attribute, H5T_NATIVE_DOUBLE, &value) < 0) {
        return {};
    }
    return value;
}

std::string text_of(hid_t attribute) {
    const Hdf5Handle type(H5Aget_type(attribute));
    if (!type || H5Tget_class(type.get()) != H5T_STRING || !is_single(attribute)) {
        return {};
    }
    std::string text;
    if (H5Tis_variable_str(type.get()) > 0) {
        char* characters = nullptr;
        if (H5Aread(attribute, type.get(), &characters) < 0 || !characters) {
            return {};
        }
        text.assign(characters, std::find(characters, characters + most_text_bytes, '\0'));
        H5free_memory(characters);
    } else if (H5Tget_size(type.get()) <= most_text_bytes) {
        text.resize(H5Tget_size(type.get()));
        if (H5Aread(attribute, type.get(), text.data()) < 0) {
            return {};
        }
        text.erase(std::find(text.begin(), text.end(), '\0'), text.end());
    }
    return text;
}

// The text of the attribute that names the unit of another one: "sampling_rate_unit".
std::string unit_beside(hid_t object, const std::string& name) {
    for (const char* ending : {"_unit", "_units"}) {
        const std::string beside = name + ending;
        if (H5Aexists(object, beside.c_str()) > 0) {
            const Hdf5Handle attribute(H5Aopen(object, beside.c_str(), H5P_DEFAULT));
            return attribute ? text_of(attribute.get()) : std::string();
        }
    }
    return {};
}

}  // namespace

Hdf5Attributes read_attributes(hid_t object) {
    Hdf5Attributes found;
    H5O_info_t info{};
    if (H5Oget_info2(object, &info, H5O_INFO_NUM_ATTRS) < 0) {
        return found;
    }
    const hsize_t count = std::min<hsize_t>(info.num_attrs, most_attributes);
    for (hsize_t i = 0; i < count; ++i) {
        const Hdf5Handle attribute(
            H5Aopen_by_idx(object, ".", H5_INDEX_NAME, H5_ITER_INC, i, H5P_DEFAULT, H5P_DEFAULT));
        if (!attribute) {
            continue;  // what an attribute says is a help, never needed
        }
        const std::string name = name_of(attribute.get());
        const std::string small = lower_text(name);
        if (meaning_of(name) == Meaning::units) {
            found.unit = text_of(attribute.get());
        } else if (name == "MATLAB_class") {
            found.matlab_class = text_of(attribute.get());
        } else if (name == "MATLAB_empty") {
            found.matlab_empty = number_of(attribute.get()).value_or(0) != 0;
        } else if (const auto number = number_of(attribute.get())) {
            if (!found.rate_hz) {
                found.rate_hz = rate_by_name(name, *number, unit_beside(object, name));
            }
            found.scaled = found.scaled || (small == "scale_factor" && *number != 1) ||
                           (small == "add_offset" && *number != 0);
        }
    }
    return found;
}

}  // namespace vybeg
