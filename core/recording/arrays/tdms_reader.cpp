#include "core/recording/arrays/tdms_reader.h"

#include "core/recording/arrays/tdms_segments.h"
#include "core/recording/bytes/number_type.h"
#include "core/recording/samples/column_source.h"
#include "core/recording/samples/reader_rules.h"
#include "core/recording/samples/sample_source.h"
#include "core/recording/samples/vocabulary.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace vybeg {
namespace {

// Coefficients of a polynomial, from the constant on.
using Polynomial = std::vector<double>;

// Conversion of a channel's raw numbers to its unit: the linear scale of the decoder, then the
// steps.
struct TdmsScaling {
    std::optional<std::uint32_t>
        scaler;  // id of the number of a DAQmx channel; empty: its only one
    Scale linear;
    std::vector<Polynomial> steps;
};

constexpr double raw_numbers = 0xFFFFFFFF;  // as the input source of a scale
constexpr double most_scales = 1000;
constexpr std::string_view count_name = "NI_Number_Of_Scales";

std::string scale_name(int index, std::string_view rest) {
    return "NI_Scale[" + std::to_string(index) + "]_" + std::string(rest);
}

// The scales of one object.
class Scales {
public:
    Scales(const FileBytes& file, const TdmsObject& channel, const TdmsObject& owner)
        : file_(file), channel_(channel), owner_(owner) {}

    std::optional<double> number(const std::string& name) const { return owner_.number(name); }
    std::string text(const std::string& name) const { return owner_.text(name); }

    // Number of scales by the file, otherwise of those described.
    double count() const {
        if (const auto told = number(std::string(count_name))) {
            return *told;
        }
        int found = 0;
        while (found < most_scales && !text(scale_name(found, "Scale_Type")).empty()) {
            ++found;
        }
        return found;
    }

    Result<TdmsScaling> read() const {
        const double scales = count();
        if (!(scales <= most_scales)) {
            return damaged(
                VYBEG_MESSAGE("Words", "the channel %1 has an impossible number of scales"));
        }
        TdmsScaling scaling;
        // From the last scale back to the raw numbers; the step found first is applied last.
        auto index = static_cast<int>(scales) - 1;
        for (int seen = 0;; ++seen) {
            const std::string type = text(scale_name(index, "Scale_Type"));
            if (type.empty()) {  // raw number of DAQmx with this id
                scaling.scaler = static_cast<std::uint32_t>(index);
                break;
            }
            if (seen > scales) {
                return damaged(VYBEG_MESSAGE(
                    "Words", "the channel %1 has scales that are each other's input"));
            }
            TRY(take(type, index, scaling));
            const double input =
                number(scale_name(index, type + "_Input_Source")).value_or(raw_numbers);
            if (input == raw_numbers || input == -1) {
                break;
            }
            if (!(input >= 0 && input < scales)) {
                return damaged(VYBEG_MESSAGE(
                    "Words", "the channel %1 has a scale whose input does not exist"));
            }
            index = static_cast<int>(input);
        }
        std::reverse(scaling.steps.begin(), scaling.steps.end());
        fold(scaling);
        return scaling;
    }

private:
    Status take(const std::string& type, int index, TdmsScaling& scaling) const {
        if (type == "Linear") {
            const auto slope = number(scale_name(index, "Linear_Slope"));
            const auto intercept = number(scale_name(index, "Linear_Y_Intercept"));
            if (!slope || !intercept) {
                return damaged(VYBEG_MESSAGE(
                    "Words", "the channel %1 has a linear scale without slope or intercept"));
            }
            scaling.steps.push_back({*intercept, *slope});
        } else if (type == "Polynomial") {
            constexpr double usual = 4;
            const double size =
                number(scale_name(index, "Polynomial_Coefficients_Size")).value_or(usual);
            Polynomial coefficients;
            for (int i = 0; i < size; ++i) {
                const auto value =
                    number(scale_name(index, "Polynomial_Coefficients[" + std::to_string(i) + "]"));
                if (!value || !std::isfinite(*value)) {
                    return damaged(VYBEG_MESSAGE(
                        "Words",
                        "the channel %1 has a polynomial scale without all of its coefficients"));
                }
                coefficients.push_back(*value);
            }
            scaling.steps.push_back(std::move(coefficients));
        } else {
            return file_.unsupported(
                "TDMS", VYBEG_MESSAGE("Words", "a scale of the kind \"%1\" (channel %2)"),
                {type, channel_.channel});
        }
        return {};
    }

    // Moves linear steps at the beginning into the scale of the decoder.
    static void fold(TdmsScaling& scaling) {
        auto& steps = scaling.steps;
        while (!steps.empty() && steps.front().size() == 2) {
            const double offset = steps.front()[0];
            const double slope = steps.front()[1];
            scaling.linear.gain *= slope;
            scaling.linear.offset = scaling.linear.offset * slope + offset;
            steps.erase(steps.begin());
        }
    }

    // %1 stands for the channel.
    Error damaged(const char* text) const {
        return file_.damaged("TDMS", text, {channel_.channel});
    }

    const FileBytes& file_;
    const TdmsObject& channel_;
    const TdmsObject& owner_;
};

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

// Scaling by the NI_Scale properties of the channel, otherwise of its group, otherwise of the file
// (`objects` in this order): from the last scale back through its input sources to the raw numbers.
// None if NI_Scaling_Status marks the samples as scaled. Errors: format_unsupported, with the name
// of the scale, for scales of sensors and others that are no function of one number;
// format_damaged.
Result<TdmsScaling> tdms_scaling(const FileBytes& file,
                                 const std::vector<const TdmsObject*>& nearest_first) {
    for (const TdmsObject* owner : nearest_first) {
        const Scales scales(file, *nearest_first.front(), *owner);
        if (scales.text("NI_Scaling_Status") == "scaled") {
            return TdmsScaling{};
        }
        if (scales.count() >= 1) {
            return scales.read();
        }
    }
    return TdmsScaling{};
}

// Source with the steps of each channel's scaling; the source itself without steps. Values that are
// not finite become NaN.
std::shared_ptr<const SampleSource> scaled_by(std::shared_ptr<const SampleSource> source,
                                              const TdmsScaling& c, const TdmsScaling& d) {
    if (c.steps.empty() && d.steps.empty()) {
        return source;
    }
    return mapped_source(std::move(source),
                         [c, d](std::span<double> samples_c, std::span<double> samples_d) {
                             apply(c, samples_c);
                             apply(d, samples_d);
                         });
}

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

    const std::vector<FoundChannel>& channels() const { return channels_; }
    bool open_ended() const { return open_ended_; }
    const FoundChannel& channel(int number) const {
        return channels_[static_cast<std::size_t>(number - 1)];
    }
    const TdmsObject& object(const FoundChannel& found) const { return objects_[found.object]; }

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
                channels_.push_back({object, std::move(*first[object])});
            } else if (has_numbers(*first[object]) && !time_) {
                time_ = FoundChannel{object, std::move(*first[object])};
            }
        }
        return {};
    }

    Result<ChosenChannel> choose(const FoundChannel& found) const {
        const TdmsObject& channel = object(found);
        auto scaling = TRY(tdms_scaling(*file_, with_owners(channel)));
        ChosenChannel chosen{found.object, NumberType::f64, std::move(scaling)};
        const auto& scalers = found.index.scalers;
        const auto undescribed = [&] {
            return file_->unsupported(
                "TDMS", VYBEG_MESSAGE("Words", "a scale that it does not describe (channel %1)"),
                {channel.channel});
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
    std::vector<FoundChannel> channels_;
    std::optional<FoundChannel> time_;  // named so, and no channel
    bool open_ended_ = false;
};

// Names, with their group in files with several groups of channels.
std::vector<Channel> describe(const TdmsReader& reader) {
    const std::string& first = reader.object(reader.channel(1)).group;
    const bool one_group = std::ranges::all_of(reader.channels(), [&](const FoundChannel& found) {
        return reader.object(found).group == first;
    });
    std::vector<Channel> channels;
    for (const FoundChannel& found : reader.channels()) {
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
        auto of_time = TRY(reader.rate_of_time());
        found.own_rate = of_time;
    }
    // Checked before the second pass.
    TRY(choose_rate(*file, found.own_rate, options));
    const auto chosen_c = reader.choose(reader.channel(options.channel_c));
    const auto chosen_d = reader.choose(reader.channel(options.channel_d));
    if (!chosen_c || !chosen_d) {
        return (chosen_c ? chosen_d : chosen_c).error();
    }
    auto columns = TRY(reader.columns(*chosen_c, *chosen_d));
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
    found.source = scaled_by(column_source(std::move(columns.c), std::move(columns.d)),
                             chosen_c->scaling, chosen_d->scaling);
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
