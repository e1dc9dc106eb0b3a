// What the tests of residuals share: recordings with noise of a known size, and their residuals.
#pragma once

#include "core/analysis/analyse.h"
#include "core/residuals/find_residuals.h"
#include "tests/closeness.h"
#include "tests/needed.h"
#include "tests/statistical/simulated_recording.h"

#include <algorithm>
#include <cmath>

namespace vybeg::test {

inline constexpr double noise = 1e-3;

inline FreeDecay still_wave(double seconds = 12) {
    FreeDecay decay;
    decay.seconds = seconds;
    decay.noise = noise;
    decay.a_B = 0.1;
    return decay;
}

inline Settings windows_of(std::int64_t length, std::int64_t hop = 0) {
    Settings settings;
    settings.window = length;
    settings.hop = hop;
    return settings;
}

inline Analysis analysed(const Recording& recording, const Settings& settings) {
    return needed(analyse(recording, settings, {}));
}

inline Residuals residuals(const Recording& recording, const Analysis& analysis,
                           const ResidualRange& range = {}) {
    return needed(find_residuals(recording, analysis, range, {}));
}

inline const ResidualLine* line_near(const Residuals& found, double f_hz) {
    const auto near = std::ranges::find_if(found.lines, [&](const ResidualLine& line) {
        return std::abs(line.f_hz - f_hz) < found.bin_hz;
    });
    return near == found.lines.end() ? nullptr : &*near;
}

inline QString names_of(const Residuals& found) {
    QString text;
    for (const ResidualLine& line : found.lines) {
        text += QString("%1 Hz: %2 of order %3; ")
                    .arg(line.f_hz)
                    .arg(static_cast<int>(line.origin))
                    .arg(line.order);
    }
    return text;
}

}  // namespace vybeg::test
