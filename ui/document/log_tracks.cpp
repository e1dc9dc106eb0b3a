#include "ui/document/log_tracks.h"

#include "core/analysis/analyse_logs.h"
#include "ui/widgets/theme.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <memory>
#include <utility>

namespace vybeg::ui {

namespace {

ShownAnalysis shownTrack(const std::filesystem::path& path, Analysis analysis) {
    ShownAnalysis shown;
    shown.name = shown.recording = QString::fromStdU16String(path.filename().u16string());
    if (analysis.track.rows() > 0) {
        shown.recorded_s = analysis.track.time_s().back() - analysis.track.time_s().front();
    }
    shown.analysis = std::make_shared<const Analysis>(std::move(analysis));
    shown.curves = curvesOf(shown.analysis);
    return shown;
}

// 2theta_A alone, continuous within each stretch.
Track trackOf(const WholeAngleLog& log) {
    const UnwrappedAngle angle = unwrapped_angle(log);
    Track track;
    for (const AngleStretch& stretch : angle.stretches) {
        Track rows(stretch.rows.size());
        std::ranges::copy(stretch.time_s, rows.time_s().begin());
        std::ranges::transform(stretch.theta, rows.values(SlowVariable::two_theta_A).begin(),
                               [](double theta) { return 2 * theta; });
        track.append(rows);
    }
    return track;
}

Result<Analysis> angleOf(const std::filesystem::path& path, const DriftSettings& settings,
                         const JobControl& job) {
    const auto log = TRY(read_whole_angle_log(path, settings.open, settings.log, job));
    Analysis analysis;
    analysis.settings.f0_hz = std::numeric_limits<double>::quiet_NaN();
    analysis.track = trackOf(log);
    analysis.settings.window = analysis.settings.hop = 1;
    analysis.plan = {0, 1, 1, static_cast<std::int64_t>(analysis.track.rows())};
    return analysis;
}

}  // namespace

LogTracks::LogTracks(const SetStore& sets, const DriftStore& drift) : sets_(sets), drift_(drift) {
    connect(&sets_, &SetStore::changed, this, &LogTracks::follow);
    connect(&drift_, &DriftStore::changed, this, &LogTracks::follow);
}

LogTracks::Input LogTracks::present() const {
    Input input;
    if (const RecordingSet* set = sets_.current(); set && isOfLogs(*set)) {
        const MeasurementSet measured = sets_.measured(*set);
        input.settings.signal = measured.settings.signal;
        input.settings.of_recordings = measured.settings.of_recordings;
        input.settings.logs = measured.settings.logs;
        for (const RecordingRef& log : measured.recordings) {
            input.logs.push_back({{}, log.path, log.open});
        }
    }
    for (const RecordingRef& log : drift_.logs()) {
        input.whole_angle.push_back(log.path);
    }
    if (!input.whole_angle.empty()) {
        input.drift.open = drift_.settings().open;
        input.drift.log = drift_.settings().log;
    }
    return input;
}

Result<std::vector<ShownAnalysis>> LogTracks::tracksOf(const Input& input, const JobControl& job) {
    std::vector<ShownAnalysis> tracks;
    const auto add = [&tracks](const std::filesystem::path& path,
                               Result<Analysis> analysis) -> Status {
        if (!analysis && analysis.error().code == ErrorCode::interrupted) {
            return analysis.error();
        }
        if (analysis && analysis->track.rows() > 0) {
            tracks.push_back(shownTrack(path, std::move(*analysis)));
        }
        return {};
    };
    for (std::size_t k = 0; k < input.logs.size(); ++k) {
        const RecordingRef& log = input.logs[k];
        Settings settings;
        static_cast<SignalSettings&>(settings) = input.settings.signal_of(k);
        TRY(add(log.path, analyse_log(log.path, log.open, input.settings.logs, settings, job)));
    }
    for (const std::filesystem::path& path : input.whole_angle) {
        TRY(add(path, angleOf(path, input.drift, job)));
    }
    return tracks;
}

void LogTracks::follow() {
    Input input = present();
    if (input == of_) {
        return;
    }
    of_ = std::move(input);
    constexpr int key = 1;
    if (of_.logs.empty() && of_.whole_angle.empty()) {
        job_.forget(key);
        take({});
        return;
    }
    job_.run<std::vector<ShownAnalysis>>(
        key, [input = of_](const JobControl& job) { return tracksOf(input, job); },
        [this](Result<std::vector<ShownAnalysis>> tracks) {
            take(tracks ? std::move(*tracks) : std::vector<ShownAnalysis>());
        });
}

void LogTracks::take(std::vector<ShownAnalysis> tracks) {
    shown_ = std::move(tracks);
    int from_last = 0;
    for (ShownAnalysis& each : shown_) {
        const CurveStyle style = curveStyle(--from_last);  // recordings take the first colours
        each.id = static_cast<AnalysisId>(--made_);
        each.color = style.color;
        each.shade = style.shade;
    }
    emit changed();
}

}  // namespace vybeg::ui

#include "moc_log_tracks.cpp"
