#include "core/recording/mat_hdf5/hdf5_file.h"

#include "core/base/plain_text.h"
#include "core/recording/bytes/file_bytes.h"
#include "core/recording/mat_hdf5/hdf5_open.h"
#include "core/recording/samples/text_fields.h"
#include "core/recording/samples/vocabulary.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace vybeg {
namespace {

// The attributes of a group or dataset about its samples.
struct Hdf5Attributes {
    std::optional<double> rate_hz;  // by rate_by_name()
    std::string unit;               // "unit" or "units"
    bool scaled = false;            // by "scale_factor" or "add_offset" of netCDF
    std::string matlab_class;       // "MATLAB_class": "double", "char", ...
    bool matlab_empty = false;      // "MATLAB_empty": the dataset holds a size, not samples
};

constexpr int most_attributes = 1000;
constexpr std::size_t most_text_bytes = 256;

std::string name_of(hid_t attribute) {
    std::array<char, most_text_bytes> name{};
    H5Aget_name(attribute, name.size(), name.data());
    return name.data();
}

bool is_real(H5T_class_t kind) {
    return kind == H5T_INTEGER || kind == H5T_FLOAT;
}

bool is_single(hid_t attribute) {
    const Hdf5Handle space(H5Aget_space(attribute));
    return space && H5Sget_simple_extent_npoints(space.get()) == 1;
}

std::optional<double> number_of(hid_t attribute) {
    const Hdf5Handle type(H5Aget_type(attribute));
    const H5T_class_t kind = type ? H5Tget_class(type.get()) : H5T_NO_CLASS;
    double value = 0;
    if (!is_real(kind) || !is_single(attribute) ||
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

// "33333 Hz", the rate or the step that an attribute of such a name holds as a text.
std::optional<double> rate_in_words(const std::string& name, const std::string& text) {
    const auto end = std::min(text.find_first_not_of("0123456789+-.,eE"), text.size());
    const std::string number = text.substr(0, end);
    const auto value = parse_field(number, number.find(',') != std::string::npos);
    return value ? rate_by_name(name, *value, trimmed(std::string_view(text).substr(end)))
                 : std::nullopt;
}

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
        } else if (!found.rate_hz) {
            found.rate_hz = rate_in_words(name, text_of(attribute.get()));
        }
    }
    return found;
}

// A field of the records that a table (PyTables, pandas) consists of: a number, or a vector of
// numbers.
struct Hdf5Field {
    std::string name;
    std::int64_t width = 1;  // numbers
    bool is_vector = false;
    int bits = 0;
    bool is_float = false;
};

constexpr std::int64_t most_width = 4096;  // numbers in a field
constexpr std::int64_t numbers_at_once = std::int64_t{1} << 17;

// Nothing for a field of another kind.
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

// Number `channel` of a field from the record `first` on. False where that fails.
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

constexpr std::size_t most_depth = 32;
constexpr std::size_t most_objects = 10000;
// Deflate's utmost is 1032:1; a dataset beyond has no samples, only a fill value.
constexpr double most_expansion = 1100;

using Extent = std::array<hsize_t, 2>;  // rows, columns; 1 for what a dataset does not have

struct Dataset {
    std::string path;
    int rank = 0;
    Extent extent{1, 1};
    std::optional<Hdf5Field> field{};  // of a table of records
    std::size_t piece_bytes = 0;       // that are unpacked at once
};

extern "C" herr_t collect_hard_link(hid_t, const char* name, const H5L_info_t* info, void* names) {
    auto& list = *static_cast<std::vector<std::string>*>(names);
    if (info->type == H5L_TYPE_HARD) {
        list.emplace_back(name);
    }
    return list.size() > most_objects ? 1 : 0;
}

class Hdf5File : public HelperFile {
public:
    Hdf5File(OpenedHdf5 opened, Naming naming) : file_(std::move(opened.file)), naming_(naming) {
        catalogue_.format = naming == Naming::matlab ? "MAT 7.3" : "HDF5";
        catalogue_.not_closed = opened.not_closed;
        H5Fget_filesize(file_.get(), &file_bytes_);
    }

    Status list() {
        const Hdf5Handle root(H5Oopen(file_.get(), "/", H5P_DEFAULT));
        return root ? list_object(root.get(), "", {}, 0)
                    : damaged(VYBEG_MESSAGE("Words", "its root group cannot be read"));
    }

    const Catalogue& catalogue() const override { return catalogue_; }

    std::int64_t memory_bytes() const override {
        std::size_t largest = 0;
        for (const Dataset& dataset : datasets_) {
            largest = std::max(largest, dataset.piece_bytes);
        }
        return static_cast<std::int64_t>(packed_pieces_held * std::min(largest, most_packed_bytes));
    }

    Status read(const SampleRequest& request, std::span<double> out) override {
        if (out.empty()) {
            return {};
        }
        const Dataset& dataset = datasets_[static_cast<std::size_t>(request.variable)];
        Hdf5Handle& handle = open_[request.variable];
        if (!handle) {
            const Hdf5Handle access = access_to_dataset(dataset.piece_bytes);
            handle = Hdf5Handle(H5Dopen(file_.get(), dataset.path.c_str(), access.get()));
        }
        const auto decoded = [&](bool done) {
            return done ? Status()
                        : damaged(VYBEG_MESSAGE("Words", "samples of %1 cannot be decoded"),
                                  {dataset.path});
        };
        if (dataset.field) {
            return decoded(
                read_field(handle.get(), *dataset.field, request.channel, request.first, out));
        }
        const Hdf5Handle space(H5Dget_space(handle.get()));
        const bool upright = dataset.extent[0] >= dataset.extent[1];
        Extent start{static_cast<hsize_t>(request.first), static_cast<hsize_t>(request.channel)};
        Extent count{static_cast<hsize_t>(request.count), 1};
        if (!upright) {
            std::swap(start[0], start[1]);
            std::swap(count[0], count[1]);
        }
        const hsize_t length = out.size();
        const Hdf5Handle memory(H5Screate_simple(1, &length, nullptr));
        if (dataset.rank > 0 && H5Sselect_hyperslab(space.get(), H5S_SELECT_SET, start.data(),
                                                    nullptr, count.data(), nullptr) < 0) {
            return damaged(VYBEG_MESSAGE("Words", "the samples of %1 cannot be found"),
                           {dataset.path});
        }
        return decoded(H5Dread(handle.get(), H5T_NATIVE_DOUBLE, memory.get(), space.get(),
                               H5P_DEFAULT, out.data()) >= 0);
    }

private:
    Error too_many_objects() const {
        return limit(VYBEG_MESSAGE("Words", "it has more than %1 objects"), most_objects);
    }

    // The attributes around a group hold for its content.
    Status list_group(hid_t group, const std::string& path, Hdf5Attributes around,
                      std::size_t depth) {
        if (depth > most_depth) {
            return limit(VYBEG_MESSAGE("Words", "its groups lie more than %1 deep"), most_depth);
        }
        if (const Hdf5Attributes own = read_attributes(group); own.rate_hz) {
            around.rate_hz = own.rate_hz;
        }
        // Before their names are gathered, which takes seconds where they are too many.
        H5G_info_t links{};
        if (H5Gget_info(group, &links) >= 0 && links.nlinks > most_objects - objects_) {
            return too_many_objects();
        }
        std::vector<std::string> names;
        hsize_t index = 0;
        const Hdf5Handle creation(H5Gget_create_plist(group));
        unsigned kept = 0;
        const bool in_order = creation && H5Pget_link_creation_order(creation.get(), &kept) >= 0 &&
                              (kept & H5P_CRT_ORDER_TRACKED) != 0;
        if (H5Literate(group, in_order ? H5_INDEX_CRT_ORDER : H5_INDEX_NAME, H5_ITER_INC, &index,
                       collect_hard_link, &names) < 0) {
            return damaged(VYBEG_MESSAGE("Words", "the group %1 cannot be read"), {path + "/"});
        }
        for (const std::string& name : names) {
            if (++objects_ > most_objects) {
                return too_many_objects();
            }
            // MATLAB's own: the cells of cell arrays, and objects; PyTables' indices.
            if (naming_ == Naming::matlab ? name.starts_with('#') : name.starts_with("_i_")) {
                continue;
            }
            const std::string full = path + "/" + name;
            const Hdf5Handle object(H5Oopen(group, name.c_str(), H5P_DEFAULT));
            if (!object) {
                return damaged(VYBEG_MESSAGE("Words", "%1 cannot be read"), {full});
            }
            TRY(list_object(object.get(), full, around, depth));
        }
        return {};
    }

    Status list_object(hid_t object, const std::string& path, const Hdf5Attributes& around,
                       std::size_t depth) {
        switch (H5Iget_type(object)) {
            case H5I_GROUP: {
                H5O_info_t info{};
                const bool known = H5Oget_info2(object, &info, H5O_INFO_BASIC) >= 0;
                // A group that was met before is a second name of it, or a ring of groups.
                if (!known || !groups_.insert(info.addr).second) {
                    return {};
                }
                return list_group(object, path, around, depth + 1);
            }
            case H5I_DATASET: return list_dataset(object, path, around);
            default: return {};
        }
    }

    Status list_dataset(hid_t object, const std::string& path, const Hdf5Attributes& around) {
        const Hdf5Handle type(H5Dget_type(object));
        const Hdf5Handle space(H5Dget_space(object));
        if (!type || !space) {
            return damaged(VYBEG_MESSAGE("Words", "%1 cannot be read"), {path});
        }
        const H5T_class_t kind = H5Tget_class(type.get());
        const Hdf5Attributes own = read_attributes(object);
        const std::set<std::string> no_numbers{"char", "logical", "cell", "function_handle"};
        if (H5Sget_simple_extent_type(space.get()) == H5S_NULL || own.matlab_empty ||
            no_numbers.contains(own.matlab_class)) {
            return {};
        }
        Dataset dataset{path, H5Sget_simple_extent_ndims(space.get())};
        const bool is_number = is_real(kind);
        const bool is_record = kind == H5T_COMPOUND && !is_complex(type.get());
        if (dataset.rank < 0 || (!is_number && kind != H5T_COMPOUND)) {
            return {};
        }
        FileVariable entry;
        entry.name = naming_ == Naming::matlab ? dotted(path) : path;
        entry.unit = own.unit;
        entry.rate_hz = own.rate_hz ? own.rate_hz : around.rate_hz;
        if (dataset.rank > 2 || own.scaled) {
            entry.unsupported = own.scaled ? Phrase::tr("values for scale_factor and add_offset")
                                           : dimensions_text(dataset.rank);
            return add(std::move(entry), std::move(dataset));
        }
        H5Sget_simple_extent_dims(space.get(), dataset.extent.data(), nullptr);
        const auto [shorter, longer] = std::minmax(dataset.extent[0], dataset.extent[1]);
        const std::size_t bytes = H5Tget_size(type.get());
        if (static_cast<double>(longer) * static_cast<double>(shorter) *
                static_cast<double>(bytes) >
            most_expansion * static_cast<double>(file_bytes_)) {
            return damaged(
                VYBEG_MESSAGE("Words", "%1 promises more samples than the file can hold"), {path});
        }
        entry.unsupported = unsupported_storage(object);
        dataset.piece_bytes = packed_piece_bytes(object);
        if (is_record) {
            return dataset.rank == 1 ? list_fields(type.get(), entry, dataset) : Status();
        }
        entry.frames = static_cast<std::int64_t>(longer);
        entry.channels = static_cast<std::int64_t>(shorter);
        entry.type = number_type_text(static_cast<int>(8 * bytes), kind == H5T_FLOAT);
        if (!is_number) {
            entry.unsupported = Phrase::tr("complex numbers");
        }
        return add(std::move(entry), std::move(dataset));
    }

    // Each field of a table's records that holds numbers is a variable; the rest of `table` and
    // `dataset` is common.
    Status list_fields(hid_t type, const FileVariable& table, const Dataset& dataset) {
        const int members = H5Tget_nmembers(type);
        for (int i = 0; i < members; ++i) {
            std::optional<Hdf5Field> field = number_field(type, static_cast<unsigned>(i));
            if (!field) {
                continue;
            }
            if (++objects_ > most_objects) {
                return too_many_objects();
            }
            FileVariable entry = table;
            entry.name += (naming_ == Naming::matlab ? "." : "/") + field->name;
            entry.frames = static_cast<std::int64_t>(dataset.extent[0]);
            entry.channels = field->width;
            entry.type = number_type_text(field->bits, field->is_float);
            Dataset records = dataset;
            records.field = std::move(field);
            TRY(add(std::move(entry), std::move(records)));
        }
        return {};
    }

    Status add(FileVariable entry, Dataset dataset) {
        catalogue_.variables.push_back(std::move(entry));
        datasets_.push_back(std::move(dataset));
        return take_value();
    }

    // The last variable's, where it is a single number.
    Status take_value() {
        FileVariable& entry = catalogue_.variables.back();
        if (entry.frames != 1 || entry.channels != 1 || !entry.unsupported.text.empty()) {
            return {};
        }
        double value = 0;
        const auto place = static_cast<std::int64_t>(datasets_.size()) - 1;
        const Status status = read({place, 0, 0, 1}, {&value, 1});
        open_.erase(place);
        entry.value = value;
        return status;
    }

    static bool is_complex(hid_t type) {
        return H5Tget_class(type) == H5T_COMPOUND && H5Tget_nmembers(type) == 2 &&
               (H5Tget_member_index(type, "real") >= 0 || H5Tget_member_index(type, "r") >= 0);
    }

    static std::string dotted(const std::string& path) {
        std::string name = path.substr(1);
        std::replace(name.begin(), name.end(), '/', '.');
        return name;
    }

    Error limit(const char* text, std::size_t most) const {
        return too_many_parts("", catalogue_.format, text, most);
    }

    Error damaged(const char* text, std::vector<MessageArg> args = {}) const {
        return {ErrorCode::format_damaged, "", {catalogue_.format, words(text, std::move(args))}};
    }

    Hdf5Handle file_;
    Naming naming_;
    hsize_t file_bytes_ = 0;
    Catalogue catalogue_;
    std::vector<Dataset> datasets_;            // one for each variable of the catalogue
    std::map<std::int64_t, Hdf5Handle> open_;  // those that have been read from
    std::set<haddr_t> groups_;
    std::size_t objects_ = 0;
};

}  // namespace

Result<std::unique_ptr<HelperFile>> open_hdf5_file(int descriptor, Naming naming) {
    OpenedHdf5 opened = open_hdf5(descriptor);
    if (!opened.file) {
        return Error{
            ErrorCode::format_damaged,
            "",
            {naming == Naming::matlab ? "MAT 7.3" : "HDF5",
             words(
                 opened.truncated
                     ? VYBEG_MESSAGE("Words",
                                     "it is shorter than its header says: cut off, or never closed")
                     : VYBEG_MESSAGE("Words", "its header does not fit the file"))}};
    }
    auto file = std::make_unique<Hdf5File>(std::move(opened), naming);
    TRY(file->list());
    return std::unique_ptr<HelperFile>(std::move(file));
}

}  // namespace vybeg
