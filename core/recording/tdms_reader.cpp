#include "core/recording/tdms_reader.h"

#include "core/base/number_text.h"
#include "core/recording/column_source.h"
#include "core/recording/selection.h"
#include "core/recording/tdms_runs.h"
#include "core/recording/tdms_segments.h"
#include "core/recording/tdms_values.h"
#include "core/recording/text_header.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace vybeg {
namespace {

constexpr std::string_view data_tag = "TDSm";
constexpr std::string_view index_tag = "TDSh";

// So that where the samples stand never takes more than the file's size and this: a vector that
// grows holds the old runs and up to twice as many places.
constexpr std::int64_t held_bytes = std::int64_t{32} << 20;
constexpr std::int64_t held_bytes_of_run = 3 * sizeof(SampleRun);

struct FoundChannel {
    std::size_t object = 0;
    NumberType type = NumberType::f64;
};

// What the first walk through the file brings.
struct Contents {
    std::vector<TdmsObject> objects;
    std::vector<FoundChannel> channels;
    bool incomplete = false;

    const TdmsObject& object(int channel) const {
        return objects[channels[static_cast<std::size_t>(channel - 1)].object];
    }
};

class TdmsReader {
public:
    TdmsReader(std::shared_ptr<const FileBytes> file, const JobControl& job)
        : file_(std::move(file)), job_(job) {}

    Result<Contents> contents() const {
        TdmsFile tdms(file_, job_);
        std::vector<std::optional<std::uint32_t>> types;  // of each object, once it has values
        std::vector<std::size_t> order;
        const Status status =
            tdms.walk([&](const TdmsSegment&, const std::vector<TdmsRawIndex>& chunk) -> Status {
                types.resize(tdms.objects().size());
                for (const TdmsRawIndex& index : chunk) {
                    if (types[index.object].value_or(index.type) != index.type) {
                        return unsupported("a channel whose type of number changes");
                    }
                    if (!types[index.object]) {
                        types[index.object] = index.type;
                        order.push_back(index.object);
                    }
                }
                return {};
            });
        if (!status) {
            return status.error();
        }
        Contents contents{tdms.objects(), {}, tdms.incomplete()};
        for (const std::size_t object : order) {
            const auto type = tdms_number(*types[object]);
            if (type && !is_time_name(contents.objects[object].channel)) {
                contents.channels.push_back({object, *type});
            }
        }
        return contents;
    }

    // Both columns, from a second walk: which channels they are is only known after the first.
    Result<std::pair<SampleColumn, SampleColumn>> columns(const Contents& contents,
                                                          const OpenOptions& options,
                                                          std::int64_t& promised) const {
        const FoundChannel c = contents.channels[static_cast<std::size_t>(options.channel_c - 1)];
        const FoundChannel d = contents.channels[static_cast<std::size_t>(options.channel_d - 1)];
        TdmsRuns runs_c(c.object);
        TdmsRuns runs_d(d.object);
        TdmsFile tdms(file_, job_);
        const auto most_runs =
            static_cast<std::size_t>((file_->size() + held_bytes) / held_bytes_of_run);
        const Status status = tdms.walk(
            [&](const TdmsSegment& segment, const std::vector<TdmsRawIndex>& chunk) -> Status {
                for (TdmsRuns* runs : {&runs_c, &runs_d}) {
                    if (const auto wrong = runs->take(segment, chunk)) {
                        return file_->error(ErrorCode::format_damaged, {"TDMS", *wrong});
                    }
                }
                return runs_c.runs().size() + runs_d.runs().size() <= most_runs
                           ? Status{}
                           : unsupported("samples in more than " + std::to_string(most_runs) +
                                         " separate pieces");
            });
        if (!status) {
            return status.error();
        }
        const auto bytes = file_part(file_, 0, file_->size());
        std::pair<SampleColumn, SampleColumn> both{{bytes, c.type, runs_c.take_runs()},
                                                   {bytes, d.type, runs_d.take_runs()}};
        for (const auto& [column, object] :
             {std::pair(&both.first, c.object), std::pair(&both.second, d.object)}) {
            if (const Status scaled = scale(contents.objects[object], *column); !scaled) {
                return scaled.error();
            }
        }
        promised = std::max(runs_c.promised(), runs_d.promised());
        return both;
    }

    // 1 / wf_increment of the channel, its group or the file.
    std::optional<double> rate(const Contents& contents, const TdmsObject& channel) const {
        for (const bool group : {true, false}) {
            const auto found = std::find_if(
                contents.objects.begin(), contents.objects.end(), [&](const TdmsObject& object) {
                    return object.channel.empty() && object.group == (group ? channel.group : "");
                });
            for (const TdmsObject* object :
                 {&channel, found == contents.objects.end() ? nullptr : &*found}) {
                const double step = object ? number(*object, "wf_increment").value_or(0) : 0;
                if (step > 0 && std::isfinite(1 / step)) {
                    return 1 / step;
                }
            }
        }
        return std::nullopt;
    }

    static std::string text(const TdmsObject& object, std::string_view property) {
        const auto found = object.properties.find(property);
        return found == object.properties.end() ? "" : found->second.text;
    }

    Error unsupported(const std::string& what) const {
        return file_->error(ErrorCode::format_unsupported, {"TDMS", what});
    }

private:
    static std::optional<double> number(const TdmsObject& object, std::string_view property) {
        const auto found = object.properties.find(property);
        return found == object.properties.end() ? std::nullopt : found->second.number;
    }

    // How the counts of a channel become its unit, unless the file says that they have already.
    Status scale(const TdmsObject& object, SampleColumn& column) const {
        const double scales = number(object, "NI_Number_Of_Scales").value_or(0);
        if (!(scales > 0) || text(object, "NI_Scaling_Status") == "scaled") {
            return {};
        }
        const auto slope = number(object, "NI_Scale[0]_Linear_Slope");
        const auto intercept = number(object, "NI_Scale[0]_Linear_Y_Intercept");
        if (scales != 1 || text(object, "NI_Scale[0]_Scale_Type") != "Linear" || !slope ||
            !intercept) {
            return unsupported("the scale of the channel " + object.channel);
        }
        column.scale.gain = *slope;
        column.scale.offset = *intercept;
        return {};
    }

    std::shared_ptr<const FileBytes> file_;
    const JobControl& job_;
};

// Names with their group where the file has several groups of channels.
std::vector<Channel> describe(const Contents& contents) {
    const std::string& first = contents.object(1).group;
    const bool one_group = std::all_of(
        contents.channels.begin(), contents.channels.end(),
        [&](const FoundChannel& found) { return contents.objects[found.object].group == first; });
    std::vector<Channel> channels;
    for (const FoundChannel& found : contents.channels) {
        const TdmsObject& object = contents.objects[found.object];
        channels.push_back({one_group ? object.channel : object.group + "/" + object.channel,
                            TdmsReader::text(object, "unit_string")});
    }
    return channels;
}

}  // namespace

bool is_tdms(std::string_view head) {
    return head.starts_with(data_tag) || head.starts_with(index_tag);
}

Result<Recording> open_tdms(std::shared_ptr<const FileBytes> file, const OpenOptions& options,
                            const JobControl& job) {
    const TdmsReader reader(file, job);
    std::string tag(index_tag.size(), '\0');
    if (const auto got = file->read(0, tag); !got) {
        return got.error();
    }
    if (tag == index_tag) {
        return reader.unsupported("only the index of the .tdms file beside it");
    }
    const auto contents = reader.contents();
    if (!contents) {
        return contents.error();
    }
    const auto count = static_cast<int>(contents->channels.size());
    if (const Status status = check_channels(*file, count, options); !status) {
        return status.error();
    }
    const TdmsObject& c = contents->object(options.channel_c);
    const auto rate_c = reader.rate(*contents, c);
    const auto rate_d = reader.rate(*contents, contents->object(options.channel_d));
    if (rate_c && rate_d && *rate_c != *rate_d) {
        return reader.unsupported("C and D at different sample rates");
    }
    const auto own = rate_c ? rate_c : rate_d;
    const auto rate = choose_rate(
        *file, own ? std::optional(SampleRate{*own, RateOrigin::file}) : std::nullopt, options);
    if (!rate) {
        return rate.error();
    }
    std::int64_t promised = 0;
    auto columns = reader.columns(*contents, options, promised);
    if (!columns) {
        return columns.error();
    }
    Recording recording;
    recording.path = file->path();
    recording.format =
        "TDMS, " + name_of(columns->first.type) + ", " + std::to_string(count) + " channels";
    recording.rate_hz = rate->hz;
    recording.rate_from = rate->from;
    recording.channels = describe(*contents);
    recording.channel_c = options.channel_c;
    recording.channel_d = options.channel_d;
    recording.start = TdmsReader::text(c, "wf_start_time");
    recording.source = column_source(std::move(columns->first), std::move(columns->second));
    if (const Status status = check_frames(*file, recording.frames()); !status) {
        return status.error();
    }
    note_early_end(promised, recording);
    if (contents->incomplete && recording.diagnostics.empty()) {
        // Nobody knows how many there were to be.
        const std::string present = integer_text(recording.frames());
        recording.diagnostics.push_back(
            {DiagnosticKind::file_ends_early, {present, present}, recording.frames(), 0});
    }
    return recording;
}

}  // namespace vybeg
