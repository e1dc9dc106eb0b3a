#include "core/recording/mat_hdf5/library_file.h"
#include "core/recording/mat_hdf5/mat_elements.h"
#include "core/recording/mat_hdf5/mat_packed.h"
#include "core/recording/samples/column_source.h"

#include <matio.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <limits>
#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace vybeg {
namespace {

constexpr int most_struct_depth = 8;
constexpr std::size_t most_variables = 10000;

// libmatio tells of damage by its log alone, and its callback knows nothing of the file: one file
// for each process.
std::string last_complaint;

void take_complaint(int level, char* message) {
    if ((level & (MATIO_LOG_LEVEL_MESSAGE | MATIO_LOG_LEVEL_DEBUG)) == 0) {
        last_complaint = message;
    }
}

struct MatCloser {
    void operator()(mat_t* mat) const { Mat_Close(mat); }
};

struct VariableCloser {
    void operator()(matvar_t* variable) const { Mat_VarFree(variable); }
};

// The same for each class: how wide its numbers are, and whether they are real numbers at all.
struct NumberClass {
    int bits = 0;  // 0: not an array of numbers
    bool is_float = false;
};

NumberClass number_class(const matvar_t& variable) {
    if (variable.isLogical) {
        return {};
    }
    switch (variable.class_type) {
        case MAT_C_DOUBLE: return {64, true};
        case MAT_C_SINGLE: return {32, true};
        case MAT_C_INT8:
        case MAT_C_UINT8: return {8, false};
        case MAT_C_INT16:
        case MAT_C_UINT16: return {16, false};
        case MAT_C_INT32:
        case MAT_C_UINT32: return {32, false};
        case MAT_C_INT64:
        case MAT_C_UINT64: return {64, false};
        default: return {};
    }
}

template <class Number>
void widen(const std::vector<char>& bytes, std::span<double> out) {
    for (std::size_t i = 0; i < out.size(); ++i) {
        Number number;
        std::memcpy(&number, bytes.data() + i * sizeof number, sizeof number);
        out[i] = static_cast<double>(number);
    }
}

void widen(const std::vector<char>& bytes, matio_classes number, std::span<double> out) {
    switch (number) {
        case MAT_C_DOUBLE: return widen<double>(bytes, out);
        case MAT_C_SINGLE: return widen<float>(bytes, out);
        case MAT_C_INT8: return widen<std::int8_t>(bytes, out);
        case MAT_C_UINT8: return widen<std::uint8_t>(bytes, out);
        case MAT_C_INT16: return widen<std::int16_t>(bytes, out);
        case MAT_C_UINT16: return widen<std::uint16_t>(bytes, out);
        case MAT_C_INT32: return widen<std::int32_t>(bytes, out);
        case MAT_C_UINT32: return widen<std::uint32_t>(bytes, out);
        case MAT_C_INT64: return widen<std::int64_t>(bytes, out);
        case MAT_C_UINT64: return widen<std::uint64_t>(bytes, out);
        default: return;
    }
}

// An array as it lies in the file: column after column.
struct Array {
    matvar_t* variable = nullptr;
    std::int64_t rows = 0;
    std::int64_t columns = 0;
};

class MatFile : public LibraryFile {
public:
    MatFile(mat_t* mat, std::string path) : mat_(mat), path_(std::move(path)) {}

    Status list() {
        catalogue_.format = Mat_GetVersion(mat_.get()) == MAT_FT_MAT4 ? "MAT 4" : "MAT 5";
        last_complaint.clear();
        while (matvar_t* variable = Mat_VarReadNextInfo(mat_.get())) {
            top_.emplace_back(variable);
            add(variable, variable->name ? variable->name : "", 0);
            if (arrays_.size() > most_variables) {
                return damaged("it has more than " + std::to_string(most_variables) + " variables");
            }
        }
        if (!last_complaint.empty()) {
            return damaged(last_complaint);
        }
        if (const Status status = open_packed(); !status) {
            return status;
        }
        return take_values();
    }

    const Catalogue& catalogue() const override { return catalogue_; }

    Status read(const SampleRequest& request, std::span<double> out) override {
        const Array& array = arrays_[static_cast<std::size_t>(request.variable)];
        if (array.variable->compression == MAT_COMPRESSION_NONE) {
            return decode(array, request.channel, request.first, out);
        }
        const auto source = packed_source(request);
        if (!source) {
            return source.error();
        }
        std::vector<double> again(out.size());
        return (*source)->read(request.first, out, again);
    }

private:
    void add(matvar_t* variable, const std::string& name, int depth) {
        if (variable->class_type == MAT_C_STRUCT) {
            add_fields(variable, name, depth);
            return;
        }
        const NumberClass number = number_class(*variable);
        if (number.bits != 0 && variable->rank > 2) {
            FileVariable entry;
            entry.name = name;
            entry.unsupported = dimensions_text(variable->rank);
            catalogue_.variables.push_back(std::move(entry));
            arrays_.push_back({variable, 0, 0});
            return;
        }
        if (number.bits == 0 || variable->rank != 2 || !variable->dims ||
            variable->dims[0] > std::numeric_limits<int>::max() ||
            variable->dims[1] > std::numeric_limits<int>::max()) {
            return;
        }
        const Array array{variable, static_cast<std::int64_t>(variable->dims[0]),
                          static_cast<std::int64_t>(variable->dims[1])};
        FileVariable entry;
        entry.name = name;
        entry.frames = std::max(array.rows, array.columns);
        entry.channels = std::min(array.rows, array.columns);
        entry.type = number_type_text(number.bits, number.is_float);
        entry.unsupported = variable->isComplex ? "complex numbers" : "";
        catalogue_.variables.push_back(std::move(entry));
        arrays_.push_back(array);
    }

    void add_fields(matvar_t* variable, const std::string& name, int depth) {
        const bool single = variable->rank == 2 && variable->dims && variable->dims[0] == 1 &&
                            variable->dims[1] == 1;
        const unsigned fields = single ? Mat_VarGetNumberOfFields(variable) : 0;
        char* const* names = Mat_VarGetStructFieldnames(variable);
        if (depth >= most_struct_depth || !names) {
            return;
        }
        for (unsigned i = 0; i < fields && arrays_.size() <= most_variables; ++i) {
            matvar_t* field = Mat_VarGetStructFieldByIndex(variable, i, 0);
            if (field && names[i]) {
                add(field, name + "." + names[i], depth + 1);
            }
        }
    }

    // Now: once the file is open, vybeg-reader may open nothing more.
    Status open_packed() {
        const bool any = std::any_of(arrays_.begin(), arrays_.end(), [](const Array& array) {
            return array.variable->compression != MAT_COMPRESSION_NONE;
        });
        if (any) {
            auto opened = PackedVariables::open(path_);
            if (!opened) {
                return opened.error();
            }
            packed_ = std::move(*opened);
        }
        return {};
    }

    Status take_values() {
        for (std::size_t i = 0; i < arrays_.size(); ++i) {
            FileVariable& entry = catalogue_.variables[i];
            if (entry.frames == 1 && entry.channels == 1 && entry.unsupported.text.empty()) {
                double value = 0;
                if (const Status status = decode(arrays_[i], 0, 0, {&value, 1}); !status) {
                    return status;
                }
                entry.value = value;
            }
        }
        return {};
    }

    // The frames of one channel (along the shorter axis) from `first` on.
    Status decode(const Array& array, std::int64_t channel, std::int64_t first,
                  std::span<double> out) {
        const bool upright = array.rows >= array.columns;
        const std::int64_t step = upright ? 1 : array.rows;  // numbers from frame to frame
        const std::int64_t start = first * step + channel * (upright ? array.rows : 1);
        if (start > std::numeric_limits<int>::max()) {
            return Error{ErrorCode::format_unsupported,
                         "",
                         {catalogue_.format, "a variable of more than 2^31 numbers"}};
        }
        const NumberClass number = number_class(*array.variable);
        std::vector<char> bytes(out.size() * static_cast<std::size_t>(number.bits / 8));
        last_complaint.clear();
        const int failed =
            Mat_VarReadDataLinear(mat_.get(), array.variable, bytes.data(), static_cast<int>(start),
                                  static_cast<int>(step), static_cast<int>(out.size()));
        if (failed != 0 || !last_complaint.empty()) {
            return damaged(last_complaint.empty() ? "samples cannot be decoded" : last_complaint);
        }
        widen(bytes, array.variable->class_type, out);
        return {};
    }

    // One channel of a compressed variable. It is kept, to be read on from where the last read
    // ended.
    Result<std::shared_ptr<const SampleSource>> packed_source(const SampleRequest& request) {
        auto& source = packed_sources_[{request.variable, request.channel}];
        if (source) {
            return source;
        }
        const auto place = static_cast<std::size_t>(request.variable);
        const Array& array = arrays_[place];
        const std::string& name = catalogue_.variables[place].name;
        auto found = packed_->find(name);
        if (!found) {
            return found.error();
        }
        const std::int64_t frames = std::max(array.rows, array.columns);
        if (found->count != array.rows * array.columns) {
            return damaged("the size of " + name + " does not fit its numbers");
        }
        const bool upright = array.rows >= array.columns;
        const std::int64_t width = bytes_of(found->type);
        const std::int64_t offset =
            found->offset + request.channel * width * (upright ? array.rows : 1);
        const SampleColumn column{
            std::move(found->bytes),
            found->type,
            {even_run(frames, offset, width * (upright ? 1 : array.rows), found->big_endian)}};
        source = column_source(column, column);
        return source;
    }

    Error damaged(const std::string& reason) const {
        return {ErrorCode::format_damaged, "", {catalogue_.format, reason}};
    }

    std::unique_ptr<mat_t, MatCloser> mat_;
    std::string path_;
    std::vector<std::unique_ptr<matvar_t, VariableCloser>> top_;
    std::vector<Array> arrays_;  // one for each variable of the catalogue
    Catalogue catalogue_;
    std::optional<PackedVariables> packed_;
    // By variable and channel: no more than the times, C and D are read.
    std::map<std::pair<std::int64_t, std::int64_t>, std::shared_ptr<const SampleSource>>
        packed_sources_;
};

}  // namespace

Result<std::unique_ptr<LibraryFile>> open_mat_file(const std::string& path) {
    if (const std::string damage = mat_damage(path); !damage.empty()) {
        return Error{ErrorCode::format_damaged, "", {"MAT", damage}};
    }
    Mat_LogInitFunc("", take_complaint);
    mat_t* const mat = Mat_Open(path.c_str(), MAT_ACC_RDONLY);
    if (!mat) {
        return Error{ErrorCode::format_damaged, "", {"MAT", "its header cannot be read"}};
    }
    auto file = std::make_unique<MatFile>(mat, path);
    if (const Status status = file->list(); !status) {
        return status.error();
    }
    return std::unique_ptr<LibraryFile>(std::move(file));
}

}  // namespace vybeg
