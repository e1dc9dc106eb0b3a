#include "core/recording/arrays/tdms_reader.h"

#include "core/recording/arrays/tdms_file.h"
#include "core/recording/bytes/number_type.h"
#include "core/recording/samples/column_source.h"
#include "core/recording/samples/reader_rules.h"
#include "core/recording/samples/sample_source.h"
#include "core/recording/samples/vocabulary.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace vybeg {
namespace {

// Layout of a chunk, and position of the channel in it.
struct Chunk {
    std::int64_t size = 0;    // bytes
    std::int64_t offset = 0;  // of the channel's first value
    std::int64_t stride = 0;  // from value to value
    std::int64_t width = 0;   // of a value
    std::int64_t count = 0;   // of the channel's values; 0: the channel is absent
    bool by_rows = false;     // a value of each channel in turn
};

Chunk chunk_for(std::size_t object, const std::vector<TdmsRawIndex>& indices, bool interleaved) {
    Chunk chunk;
    chunk.by_rows = interleaved;
    std::int64_t row = 0;
    for (const TdmsRawIndex& index : indices) {
        const std::int64_t width = tdms_bytes(index.type).value_or(0);
        if (index.object == object) {
            chunk.offset = interleaved ? row : chunk.size;
            chunk.width = width;
            chunk.count = index.count;
        }
        row += width;
        chunk.size += index.bytes;
    }
    chunk.stride = interleaved ? row : chunk.width;
    return chunk;
}

// The same for DAQmx: consecutive buffers, each with as many rows as its longest channel has
// values. Empty if the channels contradict each other about the buffers.
std::optional<Chunk> daqmx_chunk_for(std::size_t object, std::uint32_t scaler_id,
                                     const std::vector<TdmsRawIndex>& indices) {
    const std::vector<std::int64_t>& widths = indices.front().widths;
    std::vector<std::int64_t> rows(widths.size());
    for (const TdmsRawIndex& index : indices) {
        if (index.widths != widths) {
            return std::nullopt;
        }
        for (const TdmsScaler& scaler : index.scalers) {
            std::int64_t& most = rows[static_cast<std::size_t>(scaler.buffer)];
            most = std::max(most, index.count);
        }
    }
    std::vector<std::int64_t> starts;
    Chunk chunk;
    chunk.by_rows = true;
    for (std::size_t i = 0; i < widths.size(); ++i) {
        starts.push_back(chunk.size);
        chunk.size += rows[i] * widths[i];
    }
    for (const TdmsRawIndex& index : indices) {
        for (const TdmsScaler& scaler : index.scalers) {
            if (index.object == object && scaler.id == scaler_id && scaler.type) {
                const auto buffer = static_cast<std::size_t>(scaler.buffer);
                chunk.offset = starts[buffer] + scaler.offset;
                chunk.stride = widths[buffer];
                chunk.width = bytes_of(*scaler.type);
                chunk.count = index.count;
            }
        }
    }
    return chunk;
}

// Values of the channel in the first `bytes` bytes of a chunk.
std::int64_t values_in(const Chunk& chunk, std::int64_t bytes) {
    const std::int64_t room = bytes - chunk.offset - chunk.width;
    return room < 0 || chunk.count == 0 ? 0 : std::min(chunk.count, room / chunk.stride + 1);
}

// A last chunk of `bytes` bytes, divided in proportion among the channels. Empty if a product would
// exceed any file size.
std::optional<Chunk> shared_out(Chunk chunk, std::size_t object, std::int64_t bytes,
                                const std::vector<TdmsRawIndex>& indices) {
    constexpr std::int64_t most = std::numeric_limits<std::int64_t>::max();
    std::int64_t at = 0;
    for (const TdmsRawIndex& index : indices) {
        if (index.count > 0 && bytes > most / index.count) {
            return std::nullopt;
        }
        const std::int64_t values = index.count * bytes / chunk.size;
        if (index.object == object) {
            chunk.offset = at;
            chunk.count = values;
        }
        at += values * tdms_bytes(index.type).value_or(0);
    }
    return chunk;
}

bool has_texts(const std::vector<TdmsRawIndex>& indices) {
    return std::ranges::any_of(indices, [](const TdmsRawIndex& index) {
        return index.count > 0 && !tdms_bytes(index.type);
    });
}

// Collects the positions of the values of one channel, segment by segment. Contiguous ranges are
// merged, so that a file written in many pieces has a short table.
class TdmsRanges {
public:
    // `scaler`: id of the chosen numbers of a DAQmx channel.
    TdmsRanges(std::size_t object, std::uint32_t scaler) : object_(object), scaler_(scaler) {}

    // Adds the chunks of one segment. A last chunk that is shorter by its segment is divided in
    // proportion among consecutive channels; in a truncated file the present bytes count. Returns
    // the fault of the chunks, if any.
    std::optional<const char*> take(const TdmsSegment& segment,
                                    const std::vector<TdmsRawIndex>& indices) {
        const bool is_daqmx = !indices.empty() && indices.front().is_daqmx;
        if (segment.interleaved && !is_daqmx &&
            std::ranges::any_of(indices, [&](const TdmsRawIndex& index) {
                return index.count != indices.front().count || !tdms_bytes(index.type);
            })) {
            return VYBEG_MESSAGE("Words", "channels of different lengths are interleaved");
        }
        const auto made = is_daqmx
                              ? daqmx_chunk_for(object_, scaler_, indices)
                              : std::optional(chunk_for(object_, indices, segment.interleaved));
        if (!made) {
            return VYBEG_MESSAGE("Words", "its channels do not agree on the width of a row");
        }
        const Chunk& chunk = *made;
        if (chunk.size == 0) {
            return std::nullopt;
        }
        const std::int64_t whole = segment.size / chunk.size;
        const std::int64_t rest = segment.size % chunk.size;
        if (rest != 0 && !segment.last) {
            return VYBEG_MESSAGE("Words", "a segment ends within a chunk of its raw data");
        }
        if (chunk.count == 0) {
            return std::nullopt;
        }
        StridedRange range;
        range.count = whole * chunk.count;
        range.per_chunk = chunk.count;
        range.offset = segment.offset + chunk.offset;
        range.stride = chunk.stride;
        range.chunk_stride = chunk.size;
        range.big_endian = segment.big_endian;

        // The number of values of an unclosed segment is that of its whole chunks.
        const std::int64_t bytes = segment.promised.value_or(segment.size);
        const std::int64_t last = bytes % chunk.size;
        promised_ += bytes / chunk.size * chunk.count;
        if (!segment.promised || last == 0 || chunk.by_rows) {
            promised_ += last == 0 ? 0 : segment.promised ? values_in(chunk, last) : chunk.count;
            range.count += values_in(chunk, rest);
            append(range);
            return std::nullopt;
        }
        const auto share = shared_out(chunk, object_, last, indices);
        if (!share) {
            return VYBEG_MESSAGE("Words", "it promises more samples than any file can hold");
        }
        promised_ += share->count;
        if (whole < bytes / chunk.size) {  // cut before its last chunk
            range.count += values_in(chunk, rest);
            append(range);
            return std::nullopt;
        }
        append(range);
        // The number of text bytes in a shorter chunk is unknown.
        StridedRange end = range;
        end.count = has_texts(indices) ? 0 : values_in(*share, rest);
        end.per_chunk = std::max<std::int64_t>(share->count, 1);
        end.offset = segment.offset + whole * chunk.size + share->offset;
        end.chunk_stride = end.per_chunk * end.stride;
        append(end);
        return std::nullopt;
    }

    const std::vector<StridedRange>& ranges() const { return ranges_; }
    std::vector<StridedRange> take_ranges() { return std::move(ranges_); }
    // Number of values by the lead-ins of the segments; of an unclosed segment, whole chunks.
    std::int64_t promised() const { return promised_; }

private:
    void append(StridedRange range) {
        if (range.count == 0) {
            return;
        }
        range.first = ranges_.empty() ? 0 : ranges_.back().end();
        if (!ranges_.empty()) {
            StridedRange& before = ranges_.back();
            const std::int64_t chunks = before.count / before.per_chunk;
            const std::int64_t step =
                range.offset - before.offset - (chunks - 1) * before.chunk_stride;
            const bool alike =
                before.per_chunk == range.per_chunk && before.stride == range.stride &&
                before.big_endian == range.big_endian && before.count % before.per_chunk == 0;
            if (alike && (chunks == 1 || before.chunk_stride == step) &&
                (range.count <= range.per_chunk || range.chunk_stride == step)) {
                before.chunk_stride = step;
                before.count += range.count;
                return;
            }
        }
        ranges_.push_back(range);
    }

    std::size_t object_;
    std::uint32_t scaler_;
    std::int64_t promised_ = 0;
    std::vector<StridedRange> ranges_;
};

// The steps of a channel's scaling. Values that are not finite become NaN.
void apply(const TdmsScaling& scaling, std::span<double> samples) {
    for (const Polynomial& step : scaling.steps) {
        for (double& sample : samples) {
            double y = 0;
            for (auto c = step.rbegin(); c != step.rend(); ++c) {
                y = y * sample + *c;
            }
            sample = std::isfinite(y) && !std::isnan(sample)
                         ? y
                         : std::numeric_limits<double>::quiet_NaN();
        }
    }
}

constexpr std::string_view data_tag = "TDSm";
constexpr std::string_view index_tag = "TDSh";

// The table of sample positions takes at most the file's size plus this; a growing vector holds the
// old entries and room for up to twice as many.
constexpr std::int64_t held_bytes = std::int64_t{32} << 20;
constexpr std::int64_t held_bytes_of_run = 3 * sizeof(StridedRange);

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
           std::ranges::equal(a.scalers, b.scalers, [](const TdmsScaler& x, const TdmsScaler& y) {
               return x.type == y.type && x.id == y.id;
           });
}

bool has_numbers(const TdmsRawIndex& index) {
    return tdms_number(index.type) ||
           std::ranges::any_of(index.scalers,
                               [](const TdmsScaler& scaler) { return scaler.type.has_value(); });
}

class TdmsReader {
public:
    TdmsReader(std::shared_ptr<const FileBytes> file, const JobControl& job)
        : file_(std::move(file)), job_(job) {}

    // The first raw index of each.
    const std::vector<TdmsRawIndex>& channels() const { return channels_; }
    bool open_ended() const { return open_ended_; }
    const TdmsRawIndex& channel(int number) const {
        return channels_[static_cast<std::size_t>(number - 1)];
    }
    const TdmsObject& object(const TdmsRawIndex& found) const { return objects_[found.object]; }

    // A first pass through the file, which all else needs.
    Status find_channels() {
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
                    return file_->unsupported(
                        "TDMS", VYBEG_MESSAGE("Words", "a channel whose type of number changes"));
                }
            }
            return {};
        }));
        objects_ = tdms.objects();
        open_ended_ = tdms.open_ended();
        for (const std::size_t object : order) {
            const Channel named = name_and_unit(objects_[object].channel);
            if (has_numbers(*first[object]) && !is_time_name(named.name)) {
                channels_.push_back(std::move(*first[object]));
            } else if (has_numbers(*first[object]) && !time_) {
                time_ = std::move(first[object]);
            }
        }
        return {};
    }

    Result<ChosenChannel> choose(const TdmsRawIndex& found) const {
        const TdmsObject& channel = object(found);
        auto scaling = TRY(tdms_scaling(*file_, with_owners(channel)));
        ChosenChannel chosen{found.object, NumberType::f64, std::move(scaling)};
        const auto& scalers = found.scalers;
        const auto undescribed = [&] {
            return file_->unsupported(
                "TDMS", VYBEG_MESSAGE("Words", "a scale that it does not describe (channel %1)"),
                {channel.channel});
        };
        if (!found.is_daqmx) {
            chosen.type = *tdms_number(found.type);
            return chosen.scaling.scaler ? Result<ChosenChannel>(undescribed()) : chosen;
        }
        if (!chosen.scaling.scaler && scalers.size() == 1) {
            chosen.scaling.scaler = scalers.front().id;
        }
        const auto scaler = std::ranges::find_if(scalers, [&](const TdmsScaler& candidate) {
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
                        return file_->damaged("TDMS", *wrong);
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
    Result<std::optional<SampleRate>> rate_of_time() const {
        if (!time_) {
            return std::optional<SampleRate>();
        }
        const TdmsObject& times = object(*time_);
        const auto chosen = TRY(choose(*time_));
        const auto columns_twice = TRY(columns(chosen, chosen));
        Channel named = name_and_unit(times.channel);
        named.unit = named.unit.empty() ? times.text("unit_string") : named.unit;
        return rate_of_times(columns_twice.c, seconds_per(time_unit(named)).value_or(1), job_);
    }

    // 1 / wf_increment of the channel, its group or the file.
    std::optional<double> rate(const TdmsObject& channel) const {
        for (const TdmsObject* owner : with_owners(channel)) {
            const double unit_s = seconds_per(owner->text("wf_xunit_string")).value_or(1);
            const double step = unit_s * owner->number("wf_increment").value_or(0);
            if (step > 0 && std::isfinite(1 / step)) {
                return 1 / step;
            }
        }
        return std::nullopt;
    }

    // Of its first sample from the start.
    static double offset_s(const TdmsObject& channel) {
        const double offset = channel.number("wf_start_offset").value_or(0);
        return std::isfinite(offset) ? offset : 0;
    }

private:
    // The channel, its group and the file, those with properties.
    std::vector<const TdmsObject*> with_owners(const TdmsObject& channel) const {
        std::vector<const TdmsObject*> found{&channel};
        for (const std::string& group : {channel.group, std::string()}) {
            const auto owner = std::ranges::find_if(objects_, [&](const TdmsObject& each) {
                return each.channel.empty() && each.group == group;
            });
            if (owner != objects_.end()) {
                found.push_back(&*owner);
            }
        }
        return found;
    }

    std::shared_ptr<const FileBytes> file_;
    const JobControl& job_;
    std::vector<TdmsObject> objects_;
    std::vector<TdmsRawIndex> channels_;
    std::optional<TdmsRawIndex> time_;  // named so, and no channel
    bool open_ended_ = false;
};

// Names, with their group in files with several groups of channels.
std::vector<Channel> describe(const TdmsReader& reader) {
    const std::string& first = reader.object(reader.channel(1)).group;
    const bool one_group = std::ranges::all_of(reader.channels(), [&](const TdmsRawIndex& found) {
        return reader.object(found).group == first;
    });
    std::vector<Channel> channels;
    for (const TdmsRawIndex& found : reader.channels()) {
        const TdmsObject& object = reader.object(found);
        channels.push_back({one_group ? object.channel : object.group + "/" + object.channel,
                            object.text("unit_string")});
    }
    return channels;
}

}  // namespace

bool is_tdms(std::string_view head) {
    return head.starts_with(data_tag) || head.starts_with(index_tag);
}

Result<Recording> open_tdms(std::shared_ptr<const FileBytes> file, const OpenOptions& options,
                            const JobControl& job) {
    TdmsReader reader(file, job);
    const auto tag = TRY(file->text(0, std::ssize(index_tag)));
    if (tag == index_tag) {
        return file->unsupported(
            "TDMS", VYBEG_MESSAGE("Words", "only the index of the .tdms file beside it"));
    }
    TRY(reader.find_channels());
    const auto count = static_cast<int>(reader.channels().size());
    TRY(check_channels(*file, count, options));
    const TdmsObject& c = reader.object(reader.channel(options.channel_c));
    const TdmsObject& d = reader.object(reader.channel(options.channel_d));
    const auto rate_c = reader.rate(c);
    const auto rate_d = reader.rate(d);
    if (rate_c && rate_d && *rate_c != *rate_d) {
        return file->unsupported("TDMS",
                                 VYBEG_MESSAGE("Words", "C and D at different sample rates"));
    }
    const std::string start_c = c.text("wf_start_time");
    const std::string start_d = d.text("wf_start_time");
    if (!start_c.empty() && !start_d.empty() && start_c != start_d) {
        return file->unsupported("TDMS",
                                 VYBEG_MESSAGE("Words", "C and D from different times, %1 and %2"),
                                 {start_c, start_d});
    }
    FoundSamples found;
    if (const auto own = rate_c ? rate_c : rate_d) {
        found.own_rate = SampleRate{*own, RateOrigin::file};
    }
    if (!found.own_rate) {
        found.own_rate = TRY(reader.rate_of_time());
    }
    // Checked before the second pass.
    TRY(choose_rate(*file, found.own_rate, options));
    const auto chosen_c = TRY(reader.choose(reader.channel(options.channel_c)));
    const auto chosen_d = TRY(reader.choose(reader.channel(options.channel_d)));
    auto columns = TRY(reader.columns(chosen_c, chosen_d));
    found.format = {FormatPart::name("TDMS"), FormatPart::words(name_of(columns.c.type)),
                    FormatPart::channels(count)};
    found.channels = describe(reader);
    found.start = start_c;
    found.never_closed = reader.open_ended();
    if (!reader.open_ended()) {
        found.promised_frames = std::min(columns.promised_c, columns.promised_d);
    }
    const std::int64_t frames_c = columns.c.frames();
    const std::int64_t frames_d = columns.d.frames();
    found.source = column_source(std::move(columns.c), std::move(columns.d));
    if (!chosen_c.scaling.steps.empty() || !chosen_d.scaling.steps.empty()) {
        found.source = mapped_source(std::move(found.source),
                                     [c = chosen_c.scaling, d = chosen_d.scaling](
                                         std::span<double> samples_c, std::span<double> samples_d) {
                                         apply(c, samples_c);
                                         apply(d, samples_d);
                                     });
    }
    found.present_frames = found.source->frames();
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
