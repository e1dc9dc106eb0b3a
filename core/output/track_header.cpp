#include "core/output/track_header.h"

#include "core/analysis/setting_table.h"
#include "core/base/diagnostic.h"
#include "core/base/number_text.h"
#include "core/base/plain_text.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace vybeg {
namespace {

void add_results(const AnalysisSummary& analysis, std::vector<std::string>& lines) {
    lines.push_back("f0_Hz: " + round_trip_text(analysis.f0_hz()));
    lines.push_back("residual: " + round_trip_text(analysis.residual));
    if (analysis.means.windows > 0 && !std::isnan(analysis.f0_hz())) {
        lines.push_back("mean_f_Hz: " + round_trip_text(analysis.means.mean_f_hz));
        lines.push_back("mean_f_at_s: " + round_trip_text(analysis.means.mean_at_s));
        lines.push_back("sd_mean_f_Hz: " + round_trip_text(analysis.means.sd_mean_f_hz));
        lines.push_back("noise: " + round_trip_text(analysis.means.noise));
    }
    for (const Diagnostic& diagnostic : analysis.diagnostics) {
        lines.push_back((severity(diagnostic.kind) == Severity::note ? "note: " : "warning: ") +
                        english(diagnostic));
    }
}

}  // namespace

std::vector<std::string> track_header(const std::string& program, const std::filesystem::path& log,
                                      const std::string& sha256, const LogChoice& choice,
                                      const AnalysisSummary& analysis) {
    std::vector<std::string> lines{program, "input: " + plain_text(log.filename().string()),
                                   "sha256: " + sha256};
    IdentifySettings settings;
    settings.signal = analysis.settings;
    settings.logs = choice;
    settings.windows.window = analysis.plan.length;
    for (const auto& [name, value] : settings_list(settings)) {
        constexpr std::array of_both{"window", "from", "to", "kappa", "delay", "f0", "angle-zero"};
        if (std::ranges::find(of_both, name) != of_both.end() ||
            row_named(log_settings(), name) != nullptr) {
            lines.push_back(name + ": " + value);
        }
    }
    add_results(analysis, lines);
    return lines;
}

std::vector<std::string> track_header(const std::string& program, const Recording& recording,
                                      const std::string& sha256, const AnalysisSummary& analysis) {
    std::vector<std::string> lines{
        program,
        "input: " + plain_text(recording.path.filename().string()),
        "sha256: " + sha256,
        "rate: " + round_trip_text(recording.rate_hz) + " (" +
            rate_origin_name(recording.rate_from) + ")",
        "channels: " + integer_text(recording.channel_c) + "," + integer_text(recording.channel_d),
    };
    if (recording.rate_relative_sd > 0) {
        lines.push_back("rate_relative_sd: " + short_text(recording.rate_relative_sd, 3));
    }
    if (!recording.read_with.empty()) {
        lines.push_back("read with: " + recording.read_with);
    }
    for (const auto& [name, value] : settings_list(analysis.settings)) {
        lines.push_back(name + ": " + value);
    }
    add_results(analysis, lines);
    return lines;
}

std::vector<std::string> single_lines(std::span<const std::string> header) {
    std::vector<std::string> lines(header.begin(), header.end());
    for (std::string& line : lines) {
        std::ranges::replace_if(
            line, [](char character) { return static_cast<unsigned char>(character) < ' '; }, ' ');
    }
    return lines;
}

}  // namespace vybeg
