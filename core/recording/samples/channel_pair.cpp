#include "core/recording/samples/channel_pair.h"

#include "core/recording/samples/reader_rules.h"
#include "core/recording/samples/sample_source.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace vybeg {
namespace {

// Channel C of one source and channel C of another.
class PairedSource final : public SampleSource {
public:
    PairedSource(std::shared_ptr<const SampleSource> c, std::shared_ptr<const SampleSource> d)
        : c_(std::move(c)), d_(std::move(d)) {}

    std::int64_t frames() const override { return std::min(c_->frames(), d_->frames()); }
    bool seeks() const override { return c_->seeks() && d_->seeks(); }

    Status read(std::int64_t first, std::span<double> c, std::span<double> d) const override {
        std::vector<double> again(c.size());
        TRY(c_->read(first, c, again));
        return d_->read(first, d, again);
    }

private:
    std::shared_ptr<const SampleSource> c_;
    std::shared_ptr<const SampleSource> d_;
};

// The channel that was opened, named by its file where it has no name.
Channel channel_of(const Recording& recording) {
    Channel channel = recording.channel(recording.channel_c);
    if (channel.name == std::to_string(recording.channel_c)) {
        channel.name = recording.path.stem().string();
    }
    return channel;
}

}  // namespace

bool same_rates(const Recording& one, const Recording& other) {
    constexpr double deviations = 4;
    constexpr double rounding = 1e-9;
    const double apart = std::abs(one.rate_hz / other.rate_hz - 1);
    return apart <= deviations * (one.rate_relative_sd + other.rate_relative_sd) + rounding;
}

Error no_parts(const Recording& one, const std::string& other, const char* what,
               const MessageArg& of_one, const MessageArg& of_other) {
    return {ErrorCode::parts_differ, one.path.string(), {other, words(what), of_one, of_other}};
}

void align_channels(double delay_s, Recording& recording) {
    constexpr double nothing = 1e-3;  // of a sample
    const double samples = delay_s * recording.rate_hz;
    if (std::abs(samples) > nothing) {
        recording.source = delayed_source(std::move(recording.source), samples);
        recording.diagnostics.push_back(
            {DiagnosticKind::channel_delayed, {number_arg(delay_s), number_arg(samples)}});
    }
}

Result<Recording> pair_channels(Recording c, Recording d, const std::string& name_d) {
    if (!same_rates(c, d)) {
        return no_parts(c, name_d, VYBEG_MESSAGE("Words", "sample rates"),
                        number_arg(c.rate_hz, 9, "Hz"), number_arg(d.rate_hz, 9, "Hz"));
    }
    const bool same_file = c.path == d.path;
    if (!same_file && !c.start.empty() && !d.start.empty() && c.start != d.start) {
        return no_parts(c, name_d, VYBEG_MESSAGE("Words", "starts"), c.start, d.start);
    }
    const double delay_s = c.first_time_s && d.first_time_s ? *d.first_time_s - *c.first_time_s : 0;
    if (delay_s >= c.seconds() || -delay_s >= d.seconds()) {
        return no_parts(c, name_d, VYBEG_MESSAGE("Words", "first times"),
                        number_arg(*c.first_time_s, 9, "s"), number_arg(*d.first_time_s, 9, "s"));
    }
    Recording pair = c;
    pair.channels = {channel_of(c), channel_of(d)};
    if (pair.channels[0].name == pair.channels[1].name) {
        pair.channels[0].name = same_file ? "1" : c.path.stem().string();
        pair.channels[1].name = same_file ? "2" : d.path.stem().string();
    }
    pair.channel_c = 1;
    pair.channel_d = 2;
    for (FormatPart& part : pair.format) {
        part.count = part.kind == FormatPart::Kind::channels ? 2 : part.count;
    }
    if (d.rate_relative_sd < c.rate_relative_sd) {
        pair.rate_hz = d.rate_hz;
        pair.rate_relative_sd = d.rate_relative_sd;
    }
    pair.start = c.start.empty() ? d.start : c.start;
    for (const Diagnostic& diagnostic : d.diagnostics) {
        if (std::ranges::find(pair.diagnostics, diagnostic) == pair.diagnostics.end()) {
            pair.diagnostics.push_back(diagnostic);
        }
    }
    if (!same_file) {
        pair.more_files.push_back(d.file);
    }
    pair.more_files.insert(pair.more_files.end(), d.more_files.begin(), d.more_files.end());
    pair.source = std::make_shared<PairedSource>(c.source, d.source);
    match_units(pair);
    if (c.frames() != d.frames()) {
        note_unequal(c.frames(), d.frames(), pair);
    }
    align_channels(delay_s, pair);
    return pair;
}

}  // namespace vybeg
