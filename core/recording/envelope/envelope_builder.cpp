#include "core/recording/envelope/envelope_builder.h"

#include "core/recording/envelope/sparse_scan.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace vybeg {
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
