#include "core/recording/variables/library_variables.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace vybeg {
namespace {

constexpr std::string_view hdf5_signature("\x89HDF\r\n\x1a\n", 8);
constexpr std::string_view matlab_signature = "MATLAB 7.3 MAT-file";

class VariableSource final : public SampleSource {
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
    return std::shared_ptr<const SampleSource>(
        std::make_shared<VariableSource>(shared_from_this(), c, d, frames, format_.seeks));
}

bool is_hdf5(std::string_view head, const FileBytes& file) {
    if (head.starts_with(matlab_signature)) {
        return true;
    }
    std::array<char, hdf5_signature.size()> bytes{};
    for (std::int64_t at = 0; at < file.size(); at = at == 0 ? 512 : 2 * at) {
        const auto got = file.read(at, bytes);
        if (got && std::string_view(bytes.data(), bytes.size()) == hdf5_signature) {
            return true;
        }
    }
    return false;
}

Result<Recording> open_hdf5(std::shared_ptr<const FileBytes> file, const OpenOptions& options,
                            const JobControl& job) {
    const auto head = TRY(file->text(0, std::ssize(matlab_signature)));
    const bool matlab = head == matlab_signature;
    const LibraryFormat format =
        matlab ? LibraryFormat{"mat73", "MAT 7.3"} : LibraryFormat{"hdf5", "HDF5"};
    auto process = TRY(ReaderProcess::start(file, format.kind, format.name));
    VariableFile variables;
    variables.file = file;
    variables.catalogue = process->catalogue();
    variables.reader = std::make_shared<LibraryVariables>(file, format, std::move(process));
    return open_variables(variables, options, job);
}

}  // namespace vybeg
