#include "core/recording/mat_hdf5/hdf5_fields.h"

#include <algorithm>
#include <optional>
#include <utility>

namespace vybeg {
namespace {

constexpr std::int64_t most_width = 4096;  // numbers in a field
constexpr std::int64_t numbers_at_once = std::int64_t{1} << 17;

bool is_real(H5T_class_t kind) {
    return kind == H5T_INTEGER || kind == H5T_FLOAT;
}

std::optional<Hdf5Field> number_field(hid_t record, unsigned place) {
    char* const name = H5Tget_member_name(record, place);
    if (!name) {
        return {};
    }
    Hdf5Field field;
    field.name = name;
    H5free_memory(name);
    Hdf5Handle type(H5Tget_member_type(record, place));
    if (!type) {
        return {};
    }
    if (H5Tget_class(type.get()) == H5T_ARRAY) {
        hsize_t width = 0;
        if (H5Tget_array_ndims(type.get()) != 1 || H5Tget_array_dims2(type.get(), &width) != 1 ||
            width == 0 || width > most_width) {
            return {};
        }
        field.is_vector = true;
        field.width = static_cast<std::int64_t>(width);
        type = Hdf5Handle(H5Tget_super(type.get()));
    }
    const H5T_class_t kind = H5Tget_class(type.get());
    field.bits = static_cast<int>(8 * H5Tget_size(type.get()));
    field.is_float = kind == H5T_FLOAT;
    return is_real(kind) ? std::optional(field) : std::nullopt;
}

}  // namespace

std::vector<Hdf5Field> number_fields(hid_t type) {
    std::vector<Hdf5Field> fields;
    const int members = H5Tget_nmembers(type);
    for (int i = 0; i < members; ++i) {
        if (auto field = number_field(type, static_cast<unsigned>(i))) {
            fields.push_back(std::move(*field));
        }
    }
    return fields;
}

bool read_field(hid_t dataset, const Hdf5Field& field, std::int64_t channel, std::int64_t first,
                std::span<double> out) {
    // A record of this field alone: the library picks it out of the whole ones.
    const auto width = static_cast<std::size_t>(field.width);
    const hsize_t length = width;
    const Hdf5Handle numbers(field.is_vector ? H5Tarray_create2(H5T_NATIVE_DOUBLE, 1, &length)
                                             : H5Tcopy(H5T_NATIVE_DOUBLE));
    const Hdf5Handle record(H5Tcreate(H5T_COMPOUND, width * sizeof(double)));
    const Hdf5Handle space(H5Dget_space(dataset));
    if (!space || !numbers || !record ||
        H5Tinsert(record.get(), field.name.c_str(), 0, numbers.get()) < 0) {
        return false;
    }
    const auto at_once =
        static_cast<std::size_t>(std::max(numbers_at_once / field.width, std::int64_t{1}));
    std::vector<double> records(std::min(at_once, out.size()) * width);
    for (std::size_t done = 0; done < out.size(); done += at_once) {
        const std::size_t count = std::min(at_once, out.size() - done);
        const hsize_t start = static_cast<hsize_t>(first) + done;
        const hsize_t rows = count;
        const Hdf5Handle memory(H5Screate_simple(1, &rows, nullptr));
        if (H5Sselect_hyperslab(space.get(), H5S_SELECT_SET, &start, nullptr, &rows, nullptr) < 0 ||
            H5Dread(dataset, record.get(), memory.get(), space.get(), H5P_DEFAULT, records.data()) <
                0) {
            return false;
        }
        for (std::size_t i = 0; i < count; ++i) {
            out[done + i] = records[i * width + static_cast<std::size_t>(channel)];
        }
    }
    return true;
}

}  // namespace vybeg
