#include "core/recording/variables/array_variables.h"

#include "core/base/guarded.h"
#include "core/recording/variables/variable_recording.h"

#include <map>
#include <utility>

namespace vybeg {
namespace {

// The samples of a channel, through decoders of its own: two channels that stand one after the
// other would send one decoder back and forth.
Result<SampleColumn> column_of(const StoredArray& stored, std::int64_t channel) {
    auto content = TRY(stored.content());
    return npy_column(stored.array, std::move(content), channel);
}

class ArrayVariables final : public VariableReader {
public:
    explicit ArrayVariables(std::vector<StoredArray> arrays) : arrays_(std::move(arrays)) {}

    Status read(const ChannelPlace& place, std::int64_t first,
                std::span<double> out) const override {
        const auto opened = opened_.hold();
        auto& column = (*opened)[{place.variable, place.channel}];
        if (!column.bytes) {
            auto found = TRY(column_of(array(place), place.channel));
            column = std::move(found);
        }
        return read_column(column, first, out);
    }

    // Errors: those of the contents.
    Result<std::shared_ptr<const SampleSource>> source(const ChannelPlace& c, const ChannelPlace& d,
                                                       std::int64_t /*frames*/) const override {
        auto column_c = column_of(array(c), c.channel);
        auto column_d = column_of(array(d), d.channel);
        if (!column_c || !column_d) {
            return (column_c ? column_d : column_c).error();
        }
        const bool side_by_side = column_c->ranges[0].stride > bytes_of(column_c->type);
        if (c.variable == d.variable && side_by_side) {
            column_d->bytes = column_c->bytes;
        }
        return column_source(std::move(*column_c), std::move(*column_d));
    }

private:
    const StoredArray& array(const ChannelPlace& place) const {
        return arrays_[static_cast<std::size_t>(place.variable)];
    }

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

Result<Recording> open_arrays(std::shared_ptr<const FileBytes> file, const std::string& format,
                              std::vector<StoredArray> arrays, const OpenOptions& options,
                              const JobControl& job) {
    VariableFile variables;
    variables.file = file;
    variables.catalogue.format = format;
    for (const StoredArray& stored : arrays) {
        TRY(job.go_on());
        const auto value = TRY(value_of(stored));
        variables.catalogue.variables.push_back(stored.variable);
        variables.catalogue.variables.back().value = value;
    }
    variables.reader = std::make_shared<ArrayVariables>(std::move(arrays));
    return open_variables(variables, options, job);
}

}  // namespace vybeg
