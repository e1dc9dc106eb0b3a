#include "core/recording/arrays/tdms_reader.h"

#include "core/recording/arrays/tdms_scale.h"
#include "core/recording/arrays/tdms_segments.h"
#include "core/recording/arrays/time_column.h"
#include "core/recording/samples/channel_pair.h"
#include "core/recording/samples/column_source.h"
#include "core/recording/samples/reader_rules.h"
#include "core/recording/samples/vocabulary.h"

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

// The table of sample positions takes at most the file's size plus this; a growing vector holds the
// old entries and room for up to twice as many.
constexpr std::int64_t held_bytes = std::int64_t{32} << 20;
constexpr std::int64_t held_bytes_of_run = 3 * sizeof(StridedRange);

struct FoundChannel {
    std::size_t object = 0;
    TdmsRawIndex index;  // the first of its object
};

// Result of the first pass through the file.
struct Contents {
    std::vector<TdmsObject> objects;
    std::vector<FoundChannel> channels;
    std::optional<FoundChannel> time;  // named so, and no channel
    bool open_ended = false;

    const FoundChannel& channel(int number) const {
        return channels[static_cast<std::size_t>(number - 1)];
    }
    const TdmsObject& object(int number) const { return objects[channel(number).object]; }
};

// A channel to be read: the chosen numbers and their scaling.
struct ChosenChannel {
    std::size_t object = 0;
    NumberType type = NumberType::f64;
    TdmsScaling scaling;

    std::uint32_t scaler() const { return scaling.scaler.value_or(0); }
};

struct Columns {
    SampleColumn c;
    SampleColumn d;
    std::int64_t promised_c = 0;
    std::int64_t promised_d = 0;
};

bool alike(const TdmsRawIndex& a, const TdmsRawIndex& b) {
    return a.type == b.type &&
           std::equal(a.scalers.begin(), a.scalers.end(), b.scalers.begin(), b.scalers.end(),
                      [](const TdmsScaler& x, const TdmsScaler& y) {
                          return x.type == y.type && x.id == y.id;
                      });
}

bool has_numbers(const TdmsRawIndex& index) {
    return tdms_number(index.type) ||
           std::any_of(index.scalers.begin(), index.scalers.end(),
                       [](const TdmsScaler& scaler) { return scaler.type.has_value(); });
}

class TdmsReader {
public:
    TdmsReader(std::shared_ptr<const FileBytes> file, const JobControl& job)
        : file_(std::move(file)), job_(job) {}

    Result<Contents> contents() const {
        TdmsFile tdms(file_, job_);
        std::vector<std::optional<TdmsRawIndex>> first;  // of each object with values
        std::vector<std::size_t> order;
        TRY(tdms.walk([&](const TdmsSegment&, const std::vector<TdmsRawIndex>& chunk) -> Status {
            first.resize(tdms.objects().size());
            for (const TdmsRawIndex& index : chunk) {
                auto& known = first[index.object];
                if (!known) {
                    known = index;
                    order.push_back(index.object);
                } else if (!alike(*known, index)) {
                    return unsupported(
                        VYBEG_MESSAGE("Words", "a channel whose type of number changes"));
                }
            }
            return {};
        }));
        Contents contents{tdms.objects(), {}, {}, tdms.open_ended()};
        for (const std::size_t object : order) {
            const Channel named = name_and_unit(contents.objects[object].channel);
            if (has_numbers(*first[object]) && !is_time_name(named.name)) {
                contents.channels.push_back({object, std::move(*first[object])});
            } else if (has_numbers(*first[object]) && !contents.time) {
                contents.time = FoundChannel{object, std::move(*first[object])};
            }
        }
        return contents;
    }

    Result<ChosenChannel> choose(const Contents& contents, const FoundChannel& found) const {
        const TdmsObject& object = contents.objects[found.object];
        auto scaling = TRY(tdms_scaling(*file_, with_owners(contents, object)));
        ChosenChannel chosen{found.object, NumberType::f64, std::move(scaling)};
        const auto& scalers = found.index.scalers;
        const auto undescribed = [&] {
            return unsupported(
                VYBEG_MESSAGE("Words", "a scale that it does not describe (channel %1)"),
                {object.channel});
        };
        if (!found.index.is_daqmx) {
            chosen.type = *tdms_number(found.index.type);
            return chosen.scaling.scaler ? Result<ChosenChannel>(undescribed()) : chosen;
        }
        if (!chosen.scaling.scaler && scalers.size() == 1) {
            chosen.scaling.scaler = scalers.front().id;
        }
        const auto scaler =
            std::find_if(scalers.begin(), scalers.end(), [&](const TdmsScaler& candidate) {
                return candidate.type && chosen.scaling.scaler == candidate.id;
            });
        if (scaler == scalers.end()) {
            return undescribed();
        }
        chosen.type = *scaler->type;
        return chosen;
    }

    // Both columns, from a second pass, because only the first pass determines the channels.
    Result<Columns> columns(const ChosenChannel& c, const ChosenChannel& d) const {
        TdmsRanges ranges_c(c.object, c.scaler());
        TdmsRanges ranges_d(d.object, d.scaler());
        TdmsFile tdms(file_, job_);
        const auto most_ranges =
            static_cast<std::size_t>((file_->size() + held_bytes) / held_bytes_of_run);
        TRY(tdms.walk(
            [&](const TdmsSegment& segment, const std::vector<TdmsRawIndex>& chunk) -> Status {
                for (TdmsRanges* ranges : {&ranges_c, &ranges_d}) {
                    if (const auto wrong = ranges->take(segment, chunk)) {
                        return file_->error(ErrorCode::format_damaged, {"TDMS", words(*wrong)});
                    }
                }
                return ranges_c.ranges().size() + ranges_d.ranges().size() <= most_ranges
                           ? Status{}
                           : Status(too_many_parts(
                                 file_->path().string(), "TDMS",
                                 VYBEG_MESSAGE("Words",
                                               "its samples lie in more than %1 separate pieces"),
                                 most_ranges));
            }));
        const auto bytes = file_part(file_, 0, file_->size());
        Columns both{{}, {}, ranges_c.promised(), ranges_d.promised()};
        both.c = {bytes, c.type, ranges_c.take_ranges(), c.scaling.linear};
        both.d = {bytes, d.type, ranges_d.take_ranges(), d.scaling.linear};
        return both;
    }

    // The rate by the channel of times; nothing where there is none, or an uneven one.
    Result<std::optional<SampleRate>> rate_of_time(const Contents& contents) const {
        if (!contents.time) {
            return std::optional<SampleRate>();
        }
        const TdmsObject& object = contents.objects[contents.time->object];
        const auto chosen = TRY(choose(contents, *contents.time));
        const auto columns_twice = TRY(columns(chosen, chosen));
        Channel named = name_and_unit(object.channel);
        named.unit = named.unit.empty() ? text(object, "unit_string") : named.unit;
        return rate_of_times(columns_twice.c, seconds_per(time_unit(named)).value_or(1), job_);
    }

    // 1 / wf_increment of the channel, its group or the file.
    static std::optional<double> rate(const Contents& contents, const TdmsObject& channel) {
        for (const TdmsObject* object : with_owners(contents, channel)) {
            const double unit_s = seconds_per(text(*object, "wf_xunit_string")).value_or(1);
            const double step = unit_s * number(*object, "wf_increment").value_or(0);
            if (step > 0 && std::isfinite(1 / step)) {
                return 1 / step;
            }
        }
        return std::nullopt;
    }

    // Of its first sample from the start.
    static double offset_s(const TdmsObject& channel) {
        const double offset = number(channel, "wf_start_offset").value_or(0);
        return std::isfinite(offset) ? offset : 0;
    }

    static std::string text(const TdmsObject& object, std::string_view property) {
        const auto found = object.properties.find(property);
        return found == object.properties.end() ? "" : found->second.text;
    }

    Error unsupported(const char* text, std::vector<MessageArg> args = {}) const {
        return file_->error(ErrorCode::format_unsupported, {"TDMS", words(text, std::move(args))});
    }

private:
    static std::optional<double> number(const TdmsObject& object, std::string_view property) {
        const auto found = object.properties.find(property);
        return found == object.properties.end() ? std::nullopt : found->second.number;
    }

    // The channel, its group and the file, those with properties.
    static std::vector<const TdmsObject*> with_owners(const Contents& contents,
                                                      const TdmsObject& channel) {
        std::vector<const TdmsObject*> found{&channel};
        for (const std::string& group : {channel.group, std::string()}) {
            const auto owner = std::find_if(
                contents.objects.begin(), contents.objects.end(), [&](const TdmsObject& object) {
                    return object.channel.empty() && object.group == group;
                });
            if (owner != contents.objects.end()) {
                found.push_back(&*owner);
            }
        }
        return found;
    }

    std::shared_ptr<const FileBytes> file_;
    const JobControl& job_;
};

// Names, with their group in files with several groups of channels.
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
    TRY(file->read(0, tag));
    if (tag == index_tag) {
        return reader.unsupported(
            VYBEG_MESSAGE("Words", "only the index of the .tdms file beside it"));
    }
    const auto contents = TRY(reader.contents());
    const auto count = static_cast<int>(contents.channels.size());
    TRY(check_channels(*file, count, options));
    const TdmsObject& c = contents.object(options.channel_c);
    const auto rate_c = TdmsReader::rate(contents, c);
    const auto rate_d = TdmsReader::rate(contents, contents.object(options.channel_d));
    if (rate_c && rate_d && *rate_c != *rate_d) {
        return reader.unsupported(VYBEG_MESSAGE("Words", "C and D at different sample rates"));
    }
    const TdmsObject& d = contents.object(options.channel_d);
    const std::string start_c = TdmsReader::text(c, "wf_start_time");
    const std::string start_d = TdmsReader::text(d, "wf_start_time");
    if (!start_c.empty() && !start_d.empty() && start_c != start_d) {
        return reader.unsupported(VYBEG_MESSAGE("Words", "C and D from different times, %1 and %2"),
                                  {start_c, start_d});
    }
    FoundSamples found;
    if (const auto own = rate_c ? rate_c : rate_d) {
        found.own_rate = SampleRate{*own, RateOrigin::file};
    }
    if (!found.own_rate) {
        auto of_time = TRY(reader.rate_of_time(contents));
        found.own_rate = of_time;
    }
    // Checked before the second pass.
    TRY(choose_rate(*file, found.own_rate, options));
    const auto chosen_c = reader.choose(contents, contents.channel(options.channel_c));
    const auto chosen_d = reader.choose(contents, contents.channel(options.channel_d));
    if (!chosen_c || !chosen_d) {
        return (chosen_c ? chosen_d : chosen_c).error();
    }
    auto columns = TRY(reader.columns(*chosen_c, *chosen_d));
    found.format = {FormatPart::name("TDMS"), FormatPart::words(name_of(columns.c.type)),
                    FormatPart::channels(count)};
    found.channels = describe(contents);
    found.start = start_c;
    found.never_closed = contents.open_ended;
    if (!contents.open_ended) {
        found.promised_frames = std::min(columns.promised_c, columns.promised_d);
    }
    const std::int64_t frames_c = columns.c.frames();
    const std::int64_t frames_d = columns.d.frames();
    found.source = scaled_by(column_source(std::move(columns.c), std::move(columns.d)),
                             chosen_c->scaling, chosen_d->scaling);
    found.frames = found.source->frames();
    auto recording = complete_recording(*file, std::move(found), options);
    if (recording && columns.promised_c != columns.promised_d) {
        note_unequal(frames_c, frames_d, *recording);
    }
    if (recording) {
        align_channels(TdmsReader::offset_s(d) - TdmsReader::offset_s(c), *recording);
    }
    return recording;
}

}  // namespace vybeg
