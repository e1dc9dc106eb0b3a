#include "core/recording/checks/recording_check.h"

#include "core/base/guarded.h"
#include "core/base/number_text.h"
#include "core/numerics/fft.h"
#include "core/numerics/lanes.h"
#include "core/numerics/statistics.h"

#include <Eigen/Dense>

#include <algorithm>
#include <bit>
#include <cmath>
#include <complex>
#include <iterator>
#include <numbers>
#include <string>
#include <utility>

namespace vybeg {
namespace {

constexpr double least_carrier_hz = 200;
constexpr double skirts_hz = 20;  // of a carrier near a line of the mains above it

double finite(double x) {
    return std::isfinite(x) ? x : 0;
}

double mean_of(std::span<const double> x) {
    double sum = 0;
    for (const double value : x) {
        sum += finite(value);
    }
    return sum / static_cast<double>(x.size());
}

double mean_power(std::span<const double> x) {
    const double offset = mean_of(x);
    double sum = 0;
    for (const double value : x) {
        const double off = finite(value) - offset;
        sum += off * off;
    }
    return sum / static_cast<double>(x.size());
}

// Variance of white noise beside a sinusoid, which x[j-1] + x[j+1] - 2 cos(w) x[j] leaves out.
double noise_power(std::span<const double> x, double twice_cos) {
    const double offset = mean_of(x);
    double sum = 0;
    for (std::size_t j = 1; j + 1 < x.size(); ++j) {
        const double left = finite(x[j - 1]) + finite(x[j + 1]) - twice_cos * finite(x[j]) -
                            (2 - twice_cos) * offset;
        sum += left * left;
    }
    return sum / static_cast<double>(x.size() - 2) / (2 + twice_cos * twice_cos);
}

// Largest distance of equally spaced values from their polynomial of the fourth degree.
double distance_from_smooth(const std::vector<double>& values) {
    const auto count = static_cast<Eigen::Index>(values.size());
    const Eigen::VectorXd places = Eigen::VectorXd::LinSpaced(count, -1, 1);
    Eigen::Matrix<double, Eigen::Dynamic, 5> powers(count, 5);
    powers.col(0).setOnes();
    for (int k = 1; k < 5; ++k) {
        powers.col(k) = powers.col(k - 1).cwiseProduct(places);
    }
    const Eigen::Map<const Eigen::VectorXd> given(values.data(), count);
    const Eigen::VectorXd smooth = powers * powers.householderQr().solve(given);
    return (given - smooth).lpNorm<Eigen::Infinity>();
}

}  // namespace

std::vector<MainsLine> mains_lines(std::span<const double> c, std::span<const double> d,
                                   double rate_hz) {
    const auto wished = static_cast<std::size_t>(4 * rate_hz);
    const std::size_t size = std::bit_floor(std::min(c.size(), wished));
    const double bin_hz = rate_hz / static_cast<double>(size);
    std::vector<MainsLine> lines;
    if (bin_hz > 5) {
        return lines;  // too short to resolve a line at 50 Hz
    }
    std::vector<std::complex<double>> data(size);
    const double turn = 2 * std::numbers::pi / static_cast<double>(size);
    for (std::size_t j = 0; j < size; ++j) {
        const double hann = 0.5 - 0.5 * std::cos(turn * static_cast<double>(j));
        data[j] = {hann * finite(c[j]), hann * finite(d[j])};
    }
    Fft(size).forward(data);
    const auto amplitude = [&](std::size_t k) {
        return std::sqrt(std::norm(data[k]) + std::norm(data[size - k]));
    };
    const auto strongest = [&](double low_hz, double high_hz) {
        std::size_t best = 0;
        for (auto k = static_cast<std::size_t>(std::max(low_hz / bin_hz, 1.0));
             k <= static_cast<std::size_t>(high_hz / bin_hz) && k < size / 2; ++k) {
            best = best == 0 || amplitude(k) > amplitude(best) ? k : best;
        }
        return best;
    };
    const std::size_t carrier_at = strongest(least_carrier_hz, rate_hz / 2);
    const double carrier = carrier_at > 0 ? amplitude(carrier_at) : 0;
    const double carrier_hz = bin_hz * static_cast<double>(carrier_at);
    const auto look_at = [&](double f) {
        // Skirts of a fast decaying carrier.
        if (f >= least_carrier_hz && std::abs(carrier_hz - f) < skirts_hz) {
            return;
        }
        const std::size_t at_line = strongest(f - 1 - bin_hz, f + 1 + bin_hz);
        const double line = at_line > 0 ? amplitude(at_line) : 0;
        std::vector<double> around;
        for (double aside = 4 + 3 * bin_hz; aside < 24 + 20 * bin_hz; aside += bin_hz) {
            for (const double at : {f - aside, f + aside}) {
                const auto k = static_cast<std::size_t>(std::max(at / bin_hz, 1.0));
                around.push_back(amplitude(std::min(k, size / 2 - 1)));
            }
        }
        if (line > 8 * median(around) && line > 1e-3 * carrier) {
            lines.push_back({f, line / carrier});
        }
    };
    for (const double supply : supplies_hz) {
        const int harmonics = supply < least_carrier_hz ? 3 : 2;
        for (int order = 1; order <= harmonics; ++order) {
            look_at(order * supply);
        }
    }
    return lines;
}

namespace {

// Seconds from the start until the power of both channels, less that of the noise, decays as in the
// second half of the samples, in steps of a 64th of their length. 0 without a transient, where the
// power changes smoothly all the way (a beat in channels of different gain), and where the
// check is inconclusive: no exponential decay, or fewer than 4096 samples.
double start_transient_s(std::span<const double> c, std::span<const double> d, double f0_hz,
                         double rate_hz) {
    constexpr std::size_t blocks = 64;
    const std::size_t length = c.size() / blocks;
    if (length < 64) {
        return 0;  // too short to have a start
    }
    const double twice_cos = 2 * std::cos(2 * std::numbers::pi * f0_hz / rate_hz);
    std::vector<double> powers;
    std::vector<double> noises;
    for (std::size_t b = 0; b < blocks; ++b) {
        const auto part_c = c.subspan(b * length, length);
        const auto part_d = d.subspan(b * length, length);
        powers.push_back(mean_power(part_c) + mean_power(part_d));
        noises.push_back(noise_power(part_c, twice_cos) + noise_power(part_d, twice_cos));
    }
    const double noise = median(noises);
    std::vector<double> places;
    std::vector<double> logarithms;
    for (std::size_t b = 0; b < blocks; ++b) {
        const double wave = powers[b] - noise;
        if (!(wave > 0)) {
            return 0;  // noise only
        }
        places.push_back(static_cast<double>(b));
        logarithms.push_back(std::log(wave));
    }
    constexpr std::size_t half = blocks / 2;
    const LineFit line =
        fit_line(std::span(places).subspan(half), std::span(logarithms).subspan(half));
    std::vector<double> off;
    for (std::size_t b = 0; b < blocks; ++b) {
        off.push_back(logarithms[b] - line.mean_y - line.slope * (places[b] - line.mean_x));
    }
    std::vector<double> scatter;
    for (std::size_t b = half; b < blocks; ++b) {
        scatter.push_back(std::abs(off[b]));
    }
    // Two per cent of the power: a smaller change of the decay is no transient. A second half
    // without exponential decay (beats, decay down to the noise) is inconclusive.
    const double usual = 8 * median(scatter);
    if (usual > 0.2) {
        return 0;
    }
    // A beat whose power channels of different gain change slowly bends smoothly from one end to
    // the other; a transient has its end, which a polynomial does not follow.
    constexpr double bend = 0.004;
    if (distance_from_smooth(logarithms) < std::max(bend, usual / 2)) {
        return 0;
    }
    const double threshold = std::max(0.02, usual);
    // The transient ends at the first of three consecutive blocks with the usual decay.
    std::size_t end = 0;
    while (end + 3 < half &&
           !(std::abs(off[end]) < threshold && std::abs(off[end + 1]) < threshold &&
             std::abs(off[end + 2]) < threshold)) {
        ++end;
    }
    // If no part of the first half fits, the decay is not exponential and the check inconclusive.
    return end + 3 < half ? static_cast<double>(end * length) / rate_hz : 0;
}

constexpr std::int64_t chunk_frames = std::int64_t{1} << 16;
constexpr double start_s = 4;             // part checked for mains and transient
constexpr double small_offset = 5e-3;     // of the amplitude
constexpr std::size_t most_listed = 100;  // places of lost samples listed one by one

const std::array<std::string, 2> channel_names{"C", "D"};

void report_rails(const ClippingCheck& clipping, const std::string& channel, SampleFaults& faults) {
    const int levels = clipping.levels();
    if (levels == 1) {
        faults.findings.push_back({DiagnosticKind::channel_constant, {channel}});
    } else if (levels == 2) {
        faults.findings.push_back({DiagnosticKind::below_one_bit, {channel, count_arg(levels)}});
    }
    for (const ClippingCheck::Rail& rail : clipping.rails()) {
        faults.findings.push_back({DiagnosticKind::clipped,
                                   {channel, count_arg(rail.count), number_arg(rail.level)},
                                   rail.places.front().first,
                                   rail.count});
        faults.clipped.insert(faults.clipped.end(), rail.places.begin(), rail.places.end());
    }
}

// Numbers of samples, e.g. "1, 7, ...".
MessageArg list_of(const std::vector<int>& candidates, int sign) {
    constexpr int most = 6;
    std::string list;
    int listed = 0;
    for (const int lost : candidates) {
        if (lost * sign <= 0) {
            continue;
        }
        if (++listed > most) {
            list += ", ...";
            break;
        }
        list += (list.empty() ? "" : ", ") + integer_text(std::abs(lost));
    }
    return list.empty() ? Phrase::tr("none") : MessageArg(list);
}

Diagnostic finding_of(const PhaseStep& step, double rate_hz) {
    const MessageArg at_s = number_arg(static_cast<double>(step.frame) / rate_hz, 9);
    if (step.is_ambiguous) {
        return {DiagnosticKind::phase_step,
                {number_arg(step.phase_rad, 3), at_s, list_of(step.candidates, -1),
                 list_of(step.candidates, 1)},
                step.frame,
                std::abs(step.lost)};
    }
    return {step.lost > 0 ? DiagnosticKind::samples_lost : DiagnosticKind::samples_doubled,
            {count_arg(std::abs(step.lost)), at_s},
            step.frame,
            std::abs(step.lost)};
}

void report_steps(double rate_hz, SampleFaults& faults) {
    std::size_t listed = 0;
    for (const PhaseStep& step : faults.steps) {
        if (++listed > most_listed) {
            faults.findings.push_back(
                {DiagnosticKind::more_samples_lost,
                 {count_arg(static_cast<std::int64_t>(faults.steps.size() - most_listed))},
                 step.frame,
                 0});
            break;
        }
        faults.findings.push_back(finding_of(step, rate_hz));
    }
}

// Extremes and sums of a portion of a channel's samples.
struct Extent {
    double sum = 0;
    double squares = 0;
    double lowest = 0;
    double highest = 0;

    bool is_finite() const { return std::isfinite(squares); }
};

// Eight parallel sums, into which the compiler must not split a single sum.
VYBEG_DISPATCHED
Extent extent_of(std::span<const double> x) {
    Vec8 sum{};
    Vec8 squares{};
    Vec8 highest = x.size() >= lane_count ? load(x.data()) : Vec8{};
    Vec8 lowest = highest;
    std::size_t j = 0;
    for (; j + lane_count <= x.size(); j += lane_count) {
        const Vec8 value = load(x.data() + j);
        sum += value;
        squares += value * value;
        highest = value > highest ? value : highest;
        lowest = value < lowest ? value : lowest;
    }
    Extent extent{0, 0, x.empty() ? 0 : x[0], x.empty() ? 0 : x[0]};
    const auto take = [&extent](double one, double square, double high, double low) {
        extent.sum += one;
        extent.squares += square;
        extent.highest = std::max(extent.highest, high);
        extent.lowest = std::min(extent.lowest, low);
    };
    for (std::size_t k = 0; k < lane_count && j > 0; ++k) {
        take(sum[k], squares[k], highest[k], lowest[k]);
    }
    for (; j < x.size(); ++j) {
        take(x[j], x[j] * x[j], x[j], x[j]);
    }
    return extent;
}

}  // namespace

void FaultCheck::ChannelSums::add(std::span<const double> x) {
    for (const double value : x) {
        if (std::isfinite(value)) {
            sum += value;
            squares += value * value;
            ++valid;
        }
    }
}

double FaultCheck::ChannelSums::mean() const {
    return valid > 0 ? sum / static_cast<double>(valid) : 0;
}

FaultCheck::FaultCheck(std::optional<double> f0_hz, double rate_hz) : rate_hz_(rate_hz) {
    if (f0_hz) {
        fills_.emplace(*f0_hz, rate_hz);
        steps_.emplace(*f0_hz, rate_hz);
    }
}

void FaultCheck::add(std::int64_t first_frame, std::span<const double> c,
                     std::span<const double> d) {
    constexpr std::size_t portion = 2048;
    for (std::size_t at = 0; at < c.size(); at += portion) {
        const std::size_t count = std::min(portion, c.size() - at);
        const std::int64_t first = first_frame + static_cast<std::int64_t>(at);
        add_portion(first, c.subspan(at, count), d.subspan(at, count));
    }
    if (steps_) {
        steps_->add(first_frame, c, d);
    }
}

// Most portions have no missing samples and lie far from the rails; their extent is enough.
void FaultCheck::add_portion(std::int64_t first_frame, std::span<const double> c,
                             std::span<const double> d) {
    const std::array<Extent, 2> extents{extent_of(c), extent_of(d)};
    const std::array<std::span<const double>, 2> channels{c, d};
    const bool whole = extents[0].is_finite() && extents[1].is_finite();
    alike_ = alike_ && std::ranges::equal(c, d);
    if (fills_) {
        fills_->add(first_frame, c, d);
    }
    for (std::size_t j = 0; !whole && j < c.size(); ++j) {
        const int missing = (std::isfinite(c[j]) ? 0 : 1) + (std::isfinite(d[j]) ? 0 : 1);
        if (missing > 0) {
            first_missing_ =
                first_missing_ < 0 ? first_frame + static_cast<std::int64_t>(j) : first_missing_;
            missing_ += missing;
            ++frames_with_missing_;
        }
    }
    for (std::size_t k = 0; k < channels.size(); ++k) {
        const Extent& extent = extents[k];
        if (extent.is_finite()) {
            sums_[k].sum += extent.sum;
            sums_[k].squares += extent.squares;
            sums_[k].valid += static_cast<std::int64_t>(channels[k].size());
        } else {
            sums_[k].add(channels[k]);
        }
        if (extent.is_finite() && clipping_[k].are_inside(extent.lowest, extent.highest)) {
            clipping_[k].pass_over(channels[k].size());
        } else {
            clipping_[k].add(first_frame, channels[k]);
        }
    }
}

SampleFaults FaultCheck::finish() {
    SampleFaults faults;
    if (missing_ > 0) {
        faults.findings.push_back({DiagnosticKind::missing_samples,
                                   {count_arg(missing_)},
                                   first_missing_,
                                   frames_with_missing_});
    }
    if (alike_ && clipping_[0].levels() > 1) {
        faults.findings.push_back({DiagnosticKind::channels_alike, {count_arg(sums_[0].valid)}});
    }
    report_rails(clipping_[0], channel_names[0], faults);
    report_rails(clipping_[1], channel_names[1], faults);
    std::ranges::sort(faults.clipped, {}, &FrameRange::first);
    if (fills_) {
        report_fills(*fills_, faults);
    }
    if (steps_) {
        faults.steps = steps_->finish();
        report_steps(rate_hz_, faults);
    }
    return faults;
}

void FaultCheck::report_fills(FillCheck& fills, SampleFaults& faults) const {
    const auto moves = [](const ClippingCheck& channel) { return channel.levels() > 2; };
    std::vector<FrameRange> still = fills.finish();
    if (!still.empty() && std::ranges::any_of(clipping_, moves)) {
        const std::int64_t first = still.front().first;
        faults.findings.push_back(
            {DiagnosticKind::samples_still,
             {count_arg(fills.still_places()), count_arg(fills.still_frames()),
              number_arg(static_cast<double>(first) / rate_hz_, 9)},
             first,
             fills.still_frames()});
        faults.still = std::move(still);
    }
    constexpr std::int64_t few = 10;
    constexpr std::int64_t one_of = 1000;
    const std::int64_t frames = std::max(sums_[0].valid, sums_[1].valid);
    if (fills.short_fills() > few && fills.short_fills() > frames / one_of) {
        faults.findings.push_back(
            {DiagnosticKind::samples_filled,
             {count_arg(fills.short_fills()),
              number_arg(static_cast<double>(fills.first_short()) / rate_hz_, 9)},
             fills.first_short(),
             fills.short_fills()});
    }
}

std::array<FaultCheck::ChannelSums, 2> FaultCheck::moving() const {
    std::array<ChannelSums, 2> moving = sums_;
    for (std::size_t k = 0; fills_ && k < moving.size(); ++k) {
        const FillCheck::Sums& held = fills_->held()[k];
        moving[k].sum -= held.sum;
        moving[k].squares -= held.squares;
        moving[k].valid -= held.count;
    }
    return moving;
}

double FaultCheck::power() const {
    double power = 0;
    double of_means = 0;
    for (const ChannelSums& channel : moving()) {
        const double mean = channel.mean();
        of_means += mean * mean;
        power += channel.valid > 0
                     ? channel.squares / static_cast<double>(channel.valid) - mean * mean
                     : 0;
    }
    // Of constant channels the sums leave nothing but their rounding.
    constexpr double rounding = 1e-12;
    return power > rounding * of_means ? power : 0;
}

std::vector<Diagnostic> FaultCheck::offsets() const {
    // Half the square of the wave's amplitude is the power of both channels.
    const double amplitude = std::sqrt(2 * power());
    if (!(amplitude > 0)) {
        return {};
    }
    std::vector<Diagnostic> findings;
    const auto sums = moving();
    for (std::size_t i = 0; i < sums.size(); ++i) {
        const double offset = sums[i].mean();
        if (std::abs(offset) > small_offset * amplitude) {
            findings.push_back({DiagnosticKind::offset,
                                {channel_names[i], number_arg(offset),
                                 number_arg(100 * std::abs(offset) / amplitude, 3)}});
        }
    }
    return findings;
}

Result<std::vector<Diagnostic>> start_findings(const SampleSource& source, double rate_hz,
                                               std::optional<double> f0_hz) {
    const auto frames =
        static_cast<std::size_t>(std::min(static_cast<double>(source.frames()), start_s * rate_hz));
    std::vector<double> c(frames);
    std::vector<double> d(frames);
    TRY(source.read(0, c, d));
    // A channel that begins later, or is interpolated, lacks the first ones.
    std::size_t first = 0;
    while (first < frames && !std::isfinite(c[first] + d[first])) {
        ++first;
    }
    c.erase(c.begin(), c.begin() + static_cast<std::ptrdiff_t>(first));
    d.erase(d.begin(), d.begin() + static_cast<std::ptrdiff_t>(first));
    std::vector<Diagnostic> findings;
    for (const MainsLine& line : f0_hz ? mains_lines(c, d, rate_hz) : std::vector<MainsLine>()) {
        findings.push_back(
            {DiagnosticKind::mains, {number_arg(line.f_hz), number_arg(100 * line.ratio, 2)}});
    }
    if (const double seconds = f0_hz ? start_transient_s(c, d, *f0_hz, rate_hz) : 0; seconds > 0) {
        findings.push_back({DiagnosticKind::start_transient,
                            {number_arg(seconds, 2)},
                            0,
                            std::llround(seconds * rate_hz)});
    }
    return findings;
}

namespace {

// What the check says after all frames of a source, in order.
Result<FaultCheck> checked(const SampleSource& source, double rate_hz, std::optional<double> f0_hz,
                           const JobControl& job) {
    FaultCheck check(f0_hz, rate_hz);
    std::vector<double> c;
    std::vector<double> d;
    const std::int64_t frames = source.frames();
    for (std::int64_t first = 0; first < frames; first += chunk_frames) {
        TRY(job.go_on());
        c.resize(static_cast<std::size_t>(std::min(chunk_frames, frames - first)));
        d.resize(c.size());
        TRY(source.read(first, c, d));
        check.add(first, c, d);
        job.report(static_cast<double>(first) / static_cast<double>(frames));
    }
    return check;
}

}  // namespace

Result<SampleFaults> find_faults(const SampleSource& source, double rate_hz,
                                 std::optional<double> f0_hz, const JobControl& job) {
    auto check = TRY(checked(source, rate_hz, f0_hz, job));
    return check.finish();
}

Result<SampleFaults> check_recording(const SampleSource& source, double rate_hz,
                                     std::optional<double> f0_hz, const JobControl& job) {
    auto check = TRY(checked(source, rate_hz, f0_hz, job));
    SampleFaults faults = check.finish();
    const auto start = TRY(start_findings(source, rate_hz, f0_hz));
    for (const std::vector<Diagnostic>& more : {check.offsets(), start}) {
        faults.findings.insert(faults.findings.end(), more.begin(), more.end());
    }
    return faults;
}

void add_findings(const std::vector<Diagnostic>& findings, std::vector<Diagnostic>& diagnostics) {
    const bool gaps_known = std::ranges::any_of(diagnostics, [](const Diagnostic& known) {
        return known.kind == DiagnosticKind::missing_samples ||
               known.kind == DiagnosticKind::time_gap ||
               known.kind == DiagnosticKind::gaps_inserted ||
               // Whose ends no interpolation reaches.
               known.kind == DiagnosticKind::channel_delayed ||
               known.kind == DiagnosticKind::channel_clocks_apart;
    });
    std::ranges::copy_if(findings, std::back_inserter(diagnostics), [&](const Diagnostic& found) {
        return found.kind != DiagnosticKind::missing_samples || !gaps_known;
    });
}

std::shared_ptr<const SampleSource> checked_source(std::shared_ptr<const SampleSource> source,
                                                   std::shared_ptr<FaultCheck> check) {
    // The check, and the frame that it has not seen.
    const auto watched =
        std::make_shared<Guarded<std::pair<std::shared_ptr<FaultCheck>, std::int64_t>>>(
            std::move(check), 0);
    return source_of(
        source->frames(), source->seeks(),
        [source, watched](std::int64_t first, std::span<double> c, std::span<double> d) -> Status {
            TRY(source->read(first, c, d));
            const auto held = watched->hold();
            auto& [watching, next] = *held;
            const std::int64_t end = first + std::ssize(c);
            if (end > next) {
                const auto seen = static_cast<std::size_t>(std::max<std::int64_t>(next - first, 0));
                watching->add(first + static_cast<std::int64_t>(seen), c.subspan(seen),
                              d.subspan(seen));
                next = end;
            }
            return {};
        });
}

}  // namespace vybeg
