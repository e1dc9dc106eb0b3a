#include "core/recording/variables/npz_reader.h"

#include "core/recording/arrays/npy_array.h"
#include "core/recording/bytes/zip_directory.h"
#include "core/recording/variables/variable_recording.h"

#include <algorithm>
#include <map>
#include <mutex>
#include <string_view>
#include <utility>
#include <vector>

namespace vybeg {
namespace {

constexpr std::string_view ending = ".npy";

// An array in the archive; nothing but its place and header is held.
struct Member {
    ZipMember zip;
    NpyArray array;
};

// The samples of a channel, through decoders of its own: two channels that stand one after the
// other would send one decoder back and forth.
Result<SampleColumn> column_of(const std::shared_ptr<const FileBytes>& file, const Member& member,
                               std::int64_t channel) {
    auto content = zip_content(file, member.zip);
    if (!content) {
        return content.error();
    }
    return npy_column(member.array, std::move(*content), channel);
}

class NpzVariables final : public VariableReader {
public:
    NpzVariables(std::shared_ptr<const FileBytes> file, std::vector<Member> members)
        : file_(std::move(file)), members_(std::move(members)) {}

    Status read(const ChannelPlace& place, std::int64_t first,
                std::span<double> out) const override {
        const std::lock_guard lock(mutex_);
        auto& source = opened_[{place.variable, place.channel}];
        if (!source) {
            const auto column = column_of(file_, member(place), place.channel);
            if (!column) {
                return column.error();
            }
            source = column_source(*column, *column);
        }
        std::vector<double> again(out.size());
        return source->read(first, out, again);
    }

    // Errors: those of zip_content().
    Result<std::shared_ptr<const SampleSource>> source(const ChannelPlace& c,
                                                       const ChannelPlace& d) const {
        auto column_c = column_of(file_, member(c), c.channel);
        auto column_d = column_of(file_, member(d), d.channel);
        if (!column_c || !column_d) {
            return (column_c ? column_d : column_c).error();
        }
        const bool side_by_side = column_c->runs[0].stride > bytes_of(column_c->type);
        if (c.variable == d.variable && side_by_side) {
            column_d->bytes = column_c->bytes;
        }
        return column_source(std::move(*column_c), std::move(*column_d));
    }

private:
    const Member& member(const ChannelPlace& place) const {
        return members_[static_cast<std::size_t>(place.variable)];
    }

    std::shared_ptr<const FileBytes> file_;
    std::vector<Member> members_;  // as in the catalogue
    mutable std::mutex mutex_;
    // One per channel that was read, to be read on: no more than the times, C and D.
    mutable std::map<std::pair<std::int64_t, std::int64_t>, std::shared_ptr<const SampleSource>>
        opened_;
};

struct Contents {
    std::vector<Member> members;
    Catalogue catalogue;
};

// Adds an array that can be read, or why it cannot.
Status add_array(const std::shared_ptr<const FileBytes>& file, const ZipMember& zip,
                 Contents& contents) {
    FileVariable variable;
    variable.name = zip.name.substr(0, zip.name.size() - ending.size());
    Member member{zip, {}};
    const auto content = zip_content(file, zip);
    const auto array =
        content ? read_npy_header(*file, **content, "NPZ") : Result<NpyArray>(content.error());
    if (!array && array.error().code != ErrorCode::format_unsupported) {
        return array.error();
    }
    if (!array) {
        variable.unsupported = array.error().args[1];
    } else {
        member.array = *array;
        variable.frames = array->frames();
        variable.channels = array->channels();
        variable.type = name_of(array->type);
        const std::int64_t last = std::max<std::int64_t>(variable.channels - 1, 0);
        const SampleColumn column = npy_column(*array, *content, last);
        if (column.frames() < variable.frames && variable.channels > 0) {
            return file->error(ErrorCode::format_damaged,
                               {"NPZ", zip.name + " is shorter than its header says"});
        }
        if (variable.frames == 1 && variable.channels == 1) {
            double value = 0;
            double again = 0;
            const Status status = column_source(column, column)->read(0, {&value, 1}, {&again, 1});
            if (!status) {
                return status;
            }
            variable.value = value;
        }
    }
    contents.members.push_back(std::move(member));
    contents.catalogue.variables.push_back(std::move(variable));
    return {};
}

}  // namespace

Result<Recording> open_npz(std::shared_ptr<const FileBytes> file, const OpenOptions& options,
                           const JobControl& job) {
    const auto members = zip_members(*file);
    if (!members) {
        return members.error();
    }
    Contents contents;
    contents.catalogue.format = "NPZ";
    for (const ZipMember& member : *members) {
        if (job.cancelled()) {
            return file->error(ErrorCode::interrupted);
        }
        if (member.name.ends_with(ending)) {
            if (const Status status = add_array(file, member, contents); !status) {
                return status.error();
            }
        }
    }
    if (contents.members.empty()) {
        return file->error(ErrorCode::format_unsupported,
                           {"ZIP", "members other than NumPy arrays (.npy)"});
    }
    const auto reader = std::make_shared<NpzVariables>(file, std::move(contents.members));
    VariableFile variables;
    variables.file = file;
    variables.format = "NPZ";
    variables.catalogue = std::move(contents.catalogue);
    variables.reader = reader;
    variables.source = [reader](const ChannelPlace& c, const ChannelPlace& d, std::int64_t) {
        return reader->source(c, d);
    };
    return open_variables(variables, options, job);
}

}  // namespace vybeg
