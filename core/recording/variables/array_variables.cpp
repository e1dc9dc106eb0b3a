#include "core/recording/variables/array_variables.h"

#include "core/base/guarded.h"
#include "core/recording/arrays/npy_reader.h"
#include "core/recording/bytes/packed_parts.h"
#include "core/recording/variables/variable_recording.h"

#include <algorithm>
#include <map>
#include <string_view>
#include <utility>

namespace vybeg {
namespace {

// The samples of a channel, through decoders of its own: two channels one after the
// other in the file would send one decoder back and forth.
Result<SampleColumn> column_of(const StoredArray& stored, std::int64_t channel) {
    auto content = TRY(stored.content());
    return array_column(stored.array, std::move(content), channel);
}

class ArrayVariables final : public VariableReader {
public:
    ArrayVariables(Catalogue catalogue, std::vector<StoredArray> arrays)
        : catalogue_(std::move(catalogue)), arrays_(std::move(arrays)) {}

    const Catalogue& catalogue() const override { return catalogue_; }

    Status read(const ChannelPlace& place, std::int64_t first,
                std::span<double> out) const override {
        const auto opened = opened_.hold();
        auto& column = (*opened)[{place.variable, place.channel}];
        if (!column.bytes) {
            column = TRY(column_of(array(place), place.channel));
        }
        return read_column(column, first, out);
    }

    // Errors: those of the contents.
    Result<std::shared_ptr<const SampleSource>> source(const ChannelPlace& c, const ChannelPlace& d,
                                                       std::int64_t /*frames*/) const override {
        auto column_c = TRY(column_of(array(c), c.channel));
        auto column_d = TRY(column_of(array(d), d.channel));
        const bool side_by_side = column_c.ranges[0].stride > bytes_of(column_c.type);
        if (c.variable == d.variable && side_by_side) {
            column_d.bytes = column_c.bytes;
        }
        return column_source(std::move(column_c), std::move(column_d));
    }

private:
    const StoredArray& array(const ChannelPlace& place) const {
        return arrays_[static_cast<std::size_t>(place.variable)];
    }

    Catalogue catalogue_;
    std::vector<StoredArray> arrays_;  // as in the catalogue
    // One per channel that was read, to be read on: no more than the times, C and D.
    Guarded<std::map<std::pair<std::int64_t, std::int64_t>, SampleColumn>> opened_;
};

// The value of an array that is a single number.
Result<std::optional<double>> value_of(const StoredArray& stored) {
    const FileVariable& variable = stored.variable;
    if (variable.frames != 1 || variable.channels != 1 || !variable.unsupported.text.empty()) {
        return std::optional<double>();
    }
    const auto column = TRY(column_of(stored, 0));
    double value = 0;
    TRY(read_column(column, 0, {&value, 1}));
    return std::optional(value);
}

}  // namespace

Result<Recording> open_arrays(const FileBytes& file, const std::string& format,
                              std::vector<StoredArray> arrays, const OpenOptions& options,
                              const JobControl& job) {
    Catalogue catalogue;
    catalogue.format = format;
    for (const StoredArray& stored : arrays) {
        TRY(job.go_on());
        const auto value = TRY(value_of(stored));
        catalogue.variables.push_back(stored.variable);
        catalogue.variables.back().value = value;
    }
    return open_variables(file, ArrayVariables(std::move(catalogue), std::move(arrays)), options,
                          job);
}

namespace {

constexpr std::string_view ending = ".npy";

// An array, or why it cannot be read.
Result<StoredArray> array_in(const std::shared_ptr<const FileBytes>& file, const ZipMember& zip) {
    StoredArray stored;
    stored.variable.name = zip.name.substr(0, zip.name.size() - ending.size());
    stored.content = [file, zip] { return zip_content(file, zip); };
    const auto content = stored.content();
    const auto array =
        content ? read_npy_header(*file, **content, "NPZ") : Result<NpyArray>(content.error());
    if (!array && array.error().code != ErrorCode::format_unsupported) {
        return array.error();
    }
    if (!array) {
        stored.variable.unsupported = array.error().args[1];
    } else {
        stored.array = *array;
        stored.variable.frames = array->frames;
        stored.variable.channels = array->channels;
        stored.variable.type = name_of(array->type);
        if (array->channels > 0 &&
            array_column(*array, *content, array->channels - 1).frames() < array->frames) {
            return file->damaged(
                "NPZ", VYBEG_MESSAGE("Words", "%1 is shorter than its header says"), {zip.name});
        }
    }
    return stored;
}

}  // namespace

Result<Recording> open_npz(std::shared_ptr<const FileBytes> file, const OpenOptions& options,
                           const JobControl& job) {
    const auto members = TRY(zip_members(*file));
    std::vector<StoredArray> arrays;
    for (const ZipMember& member : members) {
        TRY(job.go_on());
        if (member.name.ends_with(ending)) {
            auto array = TRY(array_in(file, member));
            arrays.push_back(std::move(array));
        }
    }
    if (arrays.empty()) {
        const bool is_workbook = std::ranges::any_of(
            members, [](const ZipMember& member) { return member.name.starts_with("xl/"); });
        return file->unsupported(
            "ZIP", is_workbook ? VYBEG_MESSAGE("Words", "the sheets of a workbook")
                               : VYBEG_MESSAGE("Words", "members other than NumPy arrays (.npy)"));
    }
    return open_arrays(*file, "NPZ", std::move(arrays), options, job);
}

}  // namespace vybeg
