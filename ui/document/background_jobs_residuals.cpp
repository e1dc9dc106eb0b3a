// Jobs about what an analysis leaves of the samples; the others are in background_jobs.cpp.
#include "core/recording/samples/file_changes.h"
#include "core/residuals/find_residuals.h"
#include "core/sweep/sweep_windows.h"
#include "ui/document/background_jobs.h"

namespace vybeg::ui {

void BackgroundJobs::findResiduals(int key, const Recording& recording,
                                   std::shared_ptr<const Analysis> analysis,
                                   const ResidualRange& range,
                                   std::function<void(Result<Residuals>)> done) {
    start<Residuals>(
        others_, {Kind::residuals, key},
        [recording, analysis = std::move(analysis), range](const Ticket& ticket) {
            return find_residuals(recording, *analysis, range, JobControl(ticket.stop));
        },
        std::move(done));
}

void BackgroundJobs::readExcerpt(int key, const Recording& recording,
                                 std::shared_ptr<const Analysis> analysis,
                                 std::optional<SignalSource> known, std::int64_t first,
                                 std::int64_t count,
                                 std::function<void(Result<ExcerptOutcome>)> done) {
    start<ExcerptOutcome>(
        others_, {Kind::excerpt, key},
        [recording, analysis = std::move(analysis), known = std::move(known), first,
         count](const Ticket& ticket) -> Result<ExcerptOutcome> {
            const JobControl job(ticket.stop);
            auto source =
                TRY(known ? Result<SignalSource>(*known) : signal_source(recording, analysis, job));
            auto excerpt = TRY(signal_excerpt(source, first, count, job));
            return ExcerptOutcome{std::move(source),
                                  std::make_shared<const SignalExcerpt>(std::move(excerpt))};
        },
        std::move(done));
}

void BackgroundJobs::sweepWindows(int key, const Recording& recording, const Settings& settings,
                                  const std::vector<std::int64_t>& lengths,
                                  std::function<void(Result<WindowSweep>)> done) {
    start<WindowSweep>(
        others_, {Kind::sweep, key},
        [this, key, recording, settings, lengths](const Ticket& ticket) -> Result<WindowSweep> {
            Result<WindowSweep> found =
                sweep_windows(recording, settings, lengths, reporting(key, ticket.stop));
            TRY(unchanged(recording));
            return found;
        },
        std::move(done));
}

}  // namespace vybeg::ui
