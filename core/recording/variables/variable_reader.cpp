#include "core/recording/variables/variable_reader.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace vybeg {
namespace {

class VariableSource : public SampleSource {
public:
    VariableSource(std::shared_ptr<const VariableReader> reader, ChannelPlace c, ChannelPlace d,
                   std::int64_t frames, bool seeks)
        : reader_(std::move(reader)), c_(c), d_(d), frames_(frames), seeks_(seeks) {}

    std::int64_t frames() const override { return frames_; }
    bool seeks() const override { return seeks_; }

    // In turn, so that what the library has decoded for C serves D.
    Status read(std::int64_t first, std::span<double> c, std::span<double> d) const override {
        for (std::size_t done = 0; done < c.size(); done += frames_per_request) {
            const std::size_t count =
                std::min(static_cast<std::size_t>(frames_per_request), c.size() - done);
            const std::int64_t from = first + static_cast<std::int64_t>(done);
            TRY(reader_->read(c_, from, c.subspan(done, count)));
            TRY(reader_->read(d_, from, d.subspan(done, count)));
        }
        return {};
    }

private:
    std::shared_ptr<const VariableReader> reader_;
    ChannelPlace c_;
    ChannelPlace d_;
    std::int64_t frames_;
    bool seeks_;
};

}  // namespace

LibraryVariables::LibraryVariables(std::shared_ptr<const FileBytes> file, LibraryFormat format,
                                   std::unique_ptr<ReaderProcess> process)
    : file_(std::move(file)), format_(std::move(format)), process_(std::move(process)) {}

Status LibraryVariables::read(const ChannelPlace& place, std::int64_t first,
                              std::span<double> out) const {
    const auto process = process_.hold();
    if (!*process) {
        auto started = TRY(ReaderProcess::start(file_, format_.kind, format_.name));
        *process = std::move(started);
    }
    const SampleRequest request{place.variable, place.channel, first,
                                static_cast<std::int64_t>(out.size())};
    if (!fits(request, (*process)->catalogue())) {
        process->reset();
        return file_->error(ErrorCode::file_read_failed, {"the file changed while it was read"});
    }
    if (const Status status = (*process)->read(request, out); !status) {
        process->reset();
        return status;
    }
    std::replace_if(
        out.begin(), out.end(), [](double sample) { return std::isinf(sample); },
        std::numeric_limits<double>::quiet_NaN());
    return {};
}

Result<std::shared_ptr<const SampleSource>> LibraryVariables::source(const ChannelPlace& c,
                                                                     const ChannelPlace& d,
                                                                     std::int64_t frames) const {
    return variable_source(shared_from_this(), c, d, frames);
}

std::shared_ptr<const SampleSource> variable_source(std::shared_ptr<const VariableReader> reader,
                                                    ChannelPlace c, ChannelPlace d,
                                                    std::int64_t frames, bool seeks) {
    return std::make_shared<VariableSource>(std::move(reader), c, d, frames, seeks);
}

}  // namespace vybeg
