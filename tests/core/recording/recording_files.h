#pragma once

#include "core/base/diagnostic.h"
#include "core/base/error.h"
#include "core/recording/open/open_recording.h"
#include "core/recording/samples/open_options.h"
#include "core/recording/samples/recording.h"
#include "tests/core/recording/source_reading.h"
#include "tests/needed.h"

#include <QTemporaryDir>
#include <QTest>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <numbers>
#include <string>
#include <string_view>
#include <vector>

// Fixtures of the tests of readers: files that are written for one test, and whole recordings.
namespace vybeg::test {

// A folder that vanishes with the test.
class Folder {
public:
    std::filesystem::path file(std::string_view name) const {
        return std::filesystem::path(folder_.path().toStdString()) / name;
    }

    std::filesystem::path write(std::string_view name, std::string_view bytes) const {
        const std::filesystem::path path = file(name);
        std::ofstream(path, std::ios::binary)
            .write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
        return path;
    }

private:
    QTemporaryDir folder_;
};

inline std::string bytes_of(const std::filesystem::path& path) {
    std::ifstream stream(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

inline Samples read_all(const Recording& recording) {
    return read_all(*recording.source);
}

inline Result<Recording> open(const std::filesystem::path& path, const OpenOptions& options = {}) {
    return open_recording(path, options, {});
}

// Opens a file that must open.
inline Recording opened(const std::filesystem::path& path, const OpenOptions& options = {}) {
    return needed(open(path, options));
}

// Channel D has a file of its own.
inline OpenOptions d_in(const std::filesystem::path& path) {
    OpenOptions options{.channel_d_file = path.string()};
    return options;
}

inline const Diagnostic* find(const Recording& recording, DiagnosticKind kind) {
    for (const Diagnostic& diagnostic : recording.diagnostics) {
        if (diagnostic.kind == kind) {
            return &diagnostic;
        }
    }
    return nullptr;
}

// Two channels of a decaying wave inside -1 .. 1, C and D different everywhere.
inline Samples wave(std::size_t frames) {
    Samples samples;
    for (std::size_t i = 0; i < frames; ++i) {
        const auto k = static_cast<double>(i);
        samples.c.push_back(0.9 * std::exp(-1e-5 * k) * std::cos(0.999 * k));
        samples.d.push_back(0.4 * std::exp(-1e-5 * k) * std::cos(0.999 * k - 1.1) - 0.01);
    }
    return samples;
}

// Largest difference; infinite where only one of the two is NaN or the lengths differ.
inline double worst_difference(const std::vector<double>& a, const std::vector<double>& b) {
    constexpr double never = std::numeric_limits<double>::infinity();
    if (a.size() != b.size()) {
        return never;
    }
    double largest = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        if (std::isnan(a[i]) != std::isnan(b[i])) {
            return never;
        }
        largest = std::isnan(a[i]) ? largest : std::max(largest, std::abs(a[i] - b[i]));
    }
    return largest;
}

inline double worst_difference(const Samples& a, const Samples& b) {
    return std::max(worst_difference(a.c, b.c), worst_difference(a.d, b.d));
}

}  // namespace vybeg::test
