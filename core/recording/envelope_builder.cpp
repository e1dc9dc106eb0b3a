#include "core/recording/envelope_builder.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace vybeg {
namespace {

using Samples = std::vector<EnvelopeBucket>;

constexpr double picture_interval_s = 0.1;
constexpr double look_s = 0.3;             // a disk that has to move its head is not asked longer
constexpr std::int64_t most_looks = 2048;  // about the pixels of a window's width
constexpr std::int64_t least_looks = 64;
// A look is long enough to see the crests of any carrier above 1/256 of the sample rate, and all
// looks together are no more than a sixteenth of the recording.
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

    // The parts' number is doubled as long as there is time: whatever was reached is spread over
    // the whole recording.
    Status look() {
        const double until = job_.now() + look_s;
        for (std::int64_t parts = least_looks;
             parts <= most_looks && source_.frames() / parts >= frames_per_part; parts *= 2) {
            const Result<bool> in_time = look_at(parts, until);
            if (!in_time) {
                return in_time.error();
            }
            if (!*in_time) {
                break;
            }
        }
        if (samples_) {
            publish();
        }
        return {};
    }

    Status read_all() {
        const std::int64_t frames = source_.frames();
        for (std::size_t index = 0; index < blocks_.size(); ++index) {
            const std::int64_t at = static_cast<std::int64_t>(index) * EnvelopeBlock::frames;
            const std::int64_t length = std::min(EnvelopeBlock::frames, frames - at);
            if (const Status read = read_frames(at, length); !read) {
                return read;
            }
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
    // Looks at the beginning of each part; every other one is known from half as many parts.
    Result<bool> look_at(std::int64_t parts, double until) {
        Samples samples(static_cast<std::size_t>(parts));
        for (std::int64_t part = 0; part < parts; ++part) {
            EnvelopeBucket& sample = samples[static_cast<std::size_t>(part)];
            if (samples_ && part % 2 == 0) {
                sample = (*samples_)[static_cast<std::size_t>(part / 2)];
                continue;
            }
            if (job_.now() > until) {
                return false;
            }
            const std::int64_t first = source_.frames() * part / parts;
            if (const Status read = read_frames(first, frames_per_look); !read) {
                return read.error();
            }
            sample = bucket_of(c_, d_);
        }
        samples_ = std::make_shared<const Samples>(std::move(samples));
        return true;
    }

    Status read_frames(std::int64_t first, std::int64_t length) {
        if (job_.cancelled()) {
            return Error{.code = ErrorCode::interrupted, .where = "", .args = {}};
        }
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
        if (const Status looked = builder.look(); !looked) {
            return looked.error();
        }
    }
    if (const Status read = builder.read_all(); !read) {
        return read.error();
    }
    return builder.picture();
}

std::shared_ptr<const Envelope> sampled_envelope(std::int64_t frames, Samples samples) {
    std::vector<std::shared_ptr<const EnvelopeBlock>> blocks(
        static_cast<std::size_t>(block_count(frames)));
    return std::make_shared<const Envelope>(frames, std::move(blocks),
                                            std::make_shared<const Samples>(std::move(samples)));
}

}  // namespace vybeg
