#include "ui/signals/signal_picture.h"

#include <algorithm>
#include <cmath>

namespace vybeg::ui {
namespace {

constexpr double samples_in_pixel = 4;
constexpr double points_in_period = 12;
constexpr double least_period = 8;  // pixels of a period that is seen
constexpr double margin = 0.06;

AxisRange withMargin(const Extent& extent) {
    if (extent.low > extent.high) {
        return {-1, 1};
    }
    const double span =
        std::max(extent.high - extent.low, 1e-9 * std::max(std::abs(extent.low), extent.high));
    const double beyond = span > 0 ? margin * span : 1;
    return {extent.low - beyond, extent.high + beyond};
}

// Columns of a whole number of widths from the start of the recording, so that a signal that is
// panned does not flicker.
void addColumns(const SignalContent& content, int width, SignalPicture& picture) {
    const auto frames = static_cast<double>(content.envelope->frames());
    const double step = content.time.span() * content.rate_hz / width;
    const double first = std::floor(content.time.lower * content.rate_hz / step) * step;
    const auto from = static_cast<std::int64_t>(std::clamp(first, 0., frames));
    const auto to = static_cast<std::int64_t>(std::clamp(first + (width + 1) * step, 0., frames));
    if (from >= to) {
        return;
    }
    const double count = static_cast<double>(to - from) / step;
    picture.columns =
        content.envelope->buckets(from, to, std::max(1, static_cast<int>(std::lround(count))));
    picture.columns_from_s = static_cast<double>(from) / content.rate_hz;
    picture.columns_to_s = static_cast<double>(to) / content.rate_hz;
}

void addSamples(const SignalContent& content, SignalPicture& picture) {
    const SignalExcerpt& excerpt = *content.excerpt;
    const auto place = [&](double time_s, double beyond) {
        const double k = time_s * content.rate_hz - static_cast<double>(excerpt.first) + beyond;
        return static_cast<std::size_t>(std::clamp(k, 0., static_cast<double>(excerpt.size())));
    };
    picture.from = place(content.time.lower, -1);
    picture.to = place(content.time.upper, 2);
    picture.whole = covers(excerpt, content.time, content.frames);
}

void addWave(const SignalContent& content, int width, SignalPicture& picture) {
    const AxisRange& time = content.time;
    const double periods = content.analysis->f0_hz() * time.span();
    picture.period_pixels = width / periods;
    picture.smooth = picture.samples && picture.period_pixels >= least_period;
    if (picture.smooth) {
        const int points = static_cast<int>(std::max(points_in_period * periods, 0.5 * width));
        picture.wave =
            wave_curve(*content.analysis, content.rate_hz, time.lower, time.upper, 2 + points);
    } else {
        picture.wave =
            amplitude_curve(*content.analysis, content.rate_hz, time.lower, time.upper, width);
    }
}

void addSignal(const SignalContent& content, const SignalPicture& picture, bool d, Extent& extent) {
    const Calibration& calibration = content.calibration;
    const double gain = d ? calibration.kappa : 1;
    const double offset = d ? calibration.offset_d : calibration.offset_c;
    for (const EnvelopeBucket& column : picture.columns) {
        const ChannelRange& range = d ? column.d : column.c;
        extent.add(gain * (static_cast<double>(range.min) - offset));
        extent.add(gain * (static_cast<double>(range.max) - offset));
    }
    if (picture.samples && content.excerpt) {
        for (const double value : d ? content.excerpt->d : content.excerpt->c) {
            extent.add(value);
        }
    }
    for (const double value : d ? picture.wave.d : picture.wave.c) {
        extent.add(value);
        if (!picture.smooth) {
            extent.add(-value);
        }
    }
}

void addResidual(const SignalContent& content, const SignalPicture& picture, Extent& extent) {
    const auto both = [&](double value) {
        extent.add(value);
        extent.add(-value);
    };
    if (picture.samples && content.excerpt) {
        for (std::size_t k = 0; k < content.excerpt->size(); ++k) {
            both(content.excerpt->residual_c(k));
            both(content.excerpt->residual_d(k));
        }
    }
    for (const CurveColumn& column : picture.rms) {
        both(column.max);
    }
}

}  // namespace

bool fewSamples(const AxisRange& time, double rate_hz, int width) {
    return rate_hz > 0 && time.span() * rate_hz <= samples_in_pixel * width;
}

bool covers(const SignalExcerpt& excerpt, const AxisRange& time, std::int64_t frames) {
    const double first = std::max(0., std::ceil(time.lower * excerpt.rate_hz));
    const double end = std::min(static_cast<double>(frames), time.upper * excerpt.rate_hz);
    return static_cast<double>(excerpt.first) <= first &&
           static_cast<double>(excerpt.first) + static_cast<double>(excerpt.size()) >= end;
}

SignalPicture pictureOf(const SignalContent& content, int width) {
    SignalPicture picture;
    if (!(content.rate_hz > 0) || !(content.time.span() > 0)) {
        return picture;
    }
    picture.samples = fewSamples(content.time, content.rate_hz, width);
    if (picture.samples && content.excerpt) {
        addSamples(content, picture);
    }
    if (!picture.whole) {
        if (content.envelope) {
            addColumns(content, width, picture);
        }
        if (content.rms) {
            picture.rms = content.rms->columns(content.time, width);
        }
    }
    if (content.wave && content.analysis) {
        addWave(content, width, picture);
    }
    return picture;
}

AxisRange valuesOf(const SignalContent& content, const SignalPicture& picture, SignalPart part) {
    Extent extent;
    switch (part) {
        case SignalPart::c: addSignal(content, picture, false, extent); break;
        case SignalPart::d: addSignal(content, picture, true, extent); break;
        case SignalPart::residual: addResidual(content, picture, extent); break;
    }
    return withMargin(extent);
}

}  // namespace vybeg::ui
