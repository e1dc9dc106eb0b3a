#include "core/recording/envelope/envelope_builder.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace vybeg {
namespace {

constexpr double look_s = 0.3;  // limit of time for slow disks
constexpr std::int64_t least_parts = 64;

// Looks as buckets of equal parts.
std::vector<EnvelopeBucket> in_parts(const std::vector<ScannedPlace>& looks, std::int64_t parts) {
    EnvelopeBucket unseen = empty_bucket;
    unseen.coverage = Coverage::none;
    std::vector<EnvelopeBucket> buckets(static_cast<std::size_t>(parts), unseen);
    for (const ScannedPlace& look : looks) {
        // Places follow from times of a file and may have any value.
        if (look.place >= 0 && look.place <= 1) {
            const auto at = static_cast<std::int64_t>(look.place * static_cast<double>(parts));
            EnvelopeBucket& bucket = buckets[static_cast<std::size_t>(std::min(at, parts - 1))];
            merge(bucket, look.seen);
            bucket.coverage = Coverage::some;
        }
    }
    return buckets;
}

}  // namespace

Result<std::vector<EnvelopeBucket>> sparse_scan(
    std::int64_t most, const JobControl& job,
    const std::function<Result<ScannedPlace>(std::int64_t part, std::int64_t parts)>& look) {
    const double until = job.now() + look_s;
    std::vector<ScannedPlace> looks;
    std::int64_t complete = 0;
    for (std::int64_t parts = least_parts; parts <= most; parts *= 2) {
        // Even parts were read with half as many parts.
        const std::int64_t step = parts > least_parts ? 2 : 1;
        for (std::int64_t part = step - 1; part < parts; part += step) {
            TRY(job.go_on());
            if (job.now() > until) {
                return complete > 0 ? in_parts(looks, complete) : std::vector<EnvelopeBucket>{};
            }
            auto seen = TRY(look(part, parts));
            looks.push_back(std::move(seen));
        }
        complete = parts;
    }
    return in_parts(looks, complete);
}

namespace {

using Samples = std::vector<EnvelopeBucket>;

constexpr double picture_interval_s = 0.1;
constexpr std::int64_t most_looks = 2048;  // about the pixels of a window's width
// A look contains the crests of any carrier above 1/256 of the sample rate; all looks together are
// at most a sixteenth of the recording.
constexpr std::int64_t frames_per_look = 256;
constexpr std::int64_t frames_per_part = 16 * frames_per_look;

std::int64_t block_count(std::int64_t frames) {
    return (frames + EnvelopeBlock::frames - 1) / EnvelopeBlock::frames;
}

class Builder {
public:
    Builder(const SampleSource& source, const JobControl& job, const EnvelopeSink& sink)
        : source_(source),
          job_(job),
          sink_(sink),
          blocks_(static_cast<std::size_t>(block_count(source.frames()))),
          published_(job.now()) {}

    Status look() {
        const std::int64_t frames = source_.frames();
        auto seen = sparse_scan(std::min(most_looks, frames / frames_per_part), job_,
                                [&](std::int64_t part, std::int64_t parts) -> Result<ScannedPlace> {
                                    TRY(read_frames(frames * part / parts, frames_per_look));
                                    return ScannedPlace{
                                        static_cast<double>(part) / static_cast<double>(parts),
                                        bucket_of(c_, d_)};
                                });
        if (!seen) {
            return seen.error();
        }
        if (!seen->empty()) {
            samples_ = std::make_shared<const Samples>(std::move(*seen));
            publish();
        }
        return {};
    }

    Status read_all() {
        const std::int64_t frames = source_.frames();
        for (std::size_t index = 0; index < blocks_.size(); ++index) {
            const std::int64_t at = static_cast<std::int64_t>(index) * EnvelopeBlock::frames;
            const std::int64_t length = std::min(EnvelopeBlock::frames, frames - at);
            TRY(read_frames(at, length));
            blocks_[index] = std::make_shared<const EnvelopeBlock>(c_, d_);
            if (index + 1 < blocks_.size() && job_.now() - published_ >= picture_interval_s) {
                publish();
            }
            job_.report(static_cast<double>(at + length) / static_cast<double>(frames));
        }
        return {};
    }

    std::shared_ptr<const Envelope> picture() const {
        return std::make_shared<const Envelope>(source_.frames(), blocks_, samples_);
    }

private:
    Status read_frames(std::int64_t first, std::int64_t length) {
        TRY(job_.go_on());
        c_.resize(static_cast<std::size_t>(length));
        d_.resize(c_.size());
        return source_.read(first, c_, d_);
    }

    void publish() {
        if (sink_) {
            sink_(picture());
            published_ = job_.now();
        }
    }

    const SampleSource& source_;
    const JobControl& job_;
    const EnvelopeSink& sink_;
    std::vector<std::shared_ptr<const EnvelopeBlock>> blocks_;
    std::shared_ptr<const Samples> samples_;
    double published_;
    std::vector<double> c_;
    std::vector<double> d_;
};

}  // namespace

Result<std::shared_ptr<const Envelope>> build_envelope(const SampleSource& source,
                                                       const JobControl& job,
                                                       const EnvelopeSink& sink) {
    Builder builder(source, job, sink);
    if (sink && source.seeks()) {
        TRY(builder.look());
    }
    TRY(builder.read_all());
    return builder.picture();
}

std::shared_ptr<const Envelope> sampled_envelope(std::int64_t frames, Samples samples) {
    std::vector<std::shared_ptr<const EnvelopeBlock>> blocks(
        static_cast<std::size_t>(block_count(frames)));
    return std::make_shared<const Envelope>(frames, std::move(blocks),
                                            std::make_shared<const Samples>(std::move(samples)));
}

}  // namespace vybeg
