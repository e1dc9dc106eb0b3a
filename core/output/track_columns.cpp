#include "core/output/track_columns.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <fcntl.h>
#include <unistd.h>

namespace vybeg {
namespace {

// After t_s.
constexpr std::array value_columns{
    SlowVariable::a_A, SlowVariable::a_B,          SlowVariable::two_theta_A, SlowVariable::alpha,
    SlowVariable::f,   SlowVariable::delta_phi_CD, SlowVariable::rms};
constexpr std::array sd_columns{SlowVariable::a_A, SlowVariable::a_B, SlowVariable::two_theta_A,
                                SlowVariable::alpha, SlowVariable::f};
static_assert(1 + value_columns.size() + sd_columns.size() == track_number_columns);

constexpr std::size_t first_sd = 1 + value_columns.size();
constexpr std::size_t rows_at_once = std::size_t{1} << 16;

template <class AnyTrack>
auto column_of(AnyTrack& track, std::size_t column) {
    if (column == 0) {
        return track.time_s();
    }
    return column < first_sd ? track.values(value_columns[column - 1])
                             : track.sds(sd_columns[column - first_sd]);
}

template <class Values, class Sink>
Status pass(Values values, const Sink& sink) {
    for (std::size_t at = 0; at < values.size(); at += rows_at_once) {
        TRY(sink(values.subspan(at, std::min(rows_at_once, values.size() - at))));
    }
    return {};
}

constexpr std::size_t most_in_memory = std::size_t{1} << 23;
constexpr std::size_t piece_bytes = std::size_t{1} << 20;  // between two checks of the stop token

}  // namespace

std::string track_column_name(std::size_t column) {
    if (column == 0) {
        return "t_s";
    }
    return column < first_sd ? info(value_columns[column - 1]).column
                             : std::string("sd_") + info(sd_columns[column - first_sd]).column;
}

std::string track_column_unit(std::size_t column) {
    return column == 0         ? "s"
           : column < first_sd ? info(value_columns[column - 1]).unit
                               : info(sd_columns[column - first_sd]).unit;
}

std::span<const double> track_column(const Track& track, std::size_t column) {
    return column_of(track, column);
}

std::span<double> track_column(Track& track, std::size_t column) {
    return column_of(track, column);
}

Status MemoryColumns::numbers(std::size_t column, const NumberSink& sink) const {
    return pass(track_column(track_, column), sink);
}

Status MemoryColumns::flags(const FlagSink& sink) const {
    return pass(track_.flags(), sink);
}

Status TrackSpool::create_file() {
    const std::filesystem::path folder = output_.spool_folder();
    file_ = Descriptor(open(folder.c_str(), O_TMPFILE | O_RDWR | O_CLOEXEC, 0600));
    if (!file_ && (errno == EOPNOTSUPP || errno == EISDIR || errno == EINVAL)) {
        // For a file system without unnamed files.
        TemporaryFile named = make_temporary(folder);
        if (!named.descriptor) {
            return failed(named.error);
        }
        unlink(named.path.c_str());
        file_ = std::move(named.descriptor);
    }
    return file_ ? Status{} : failed(errno);
}

Status TrackSpool::write(std::span<const std::byte> bytes) {
    memory_.append(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    if (memory_.size() >= most_in_memory) {
        TRY(file_ ? Status{} : create_file());
        TRY(write_out(memory_));
        memory_.clear();
    }
    return {};
}

Status TrackSpool::write_out(std::string_view left) {
    while (!left.empty()) {
        TRY(job_.go_on());
        const ssize_t written =
            ::write(file_.get(), left.data(), std::min(left.size(), piece_bytes));
        if (written < 0 && errno != EINTR) {
            return failed(errno);
        }
        left.remove_prefix(static_cast<std::size_t>(std::max<ssize_t>(written, 0)));
        spilled_ += std::max<ssize_t>(written, 0);
    }
    return {};
}

Status TrackSpool::read(std::int64_t from, std::span<std::byte> to) const {
    const std::span<char> bytes(reinterpret_cast<char*>(to.data()), to.size());
    std::size_t of_file = 0;
    if (from < spilled_) {
        TRY(job_.go_on());
        of_file = std::min(static_cast<std::size_t>(spilled_ - from), to.size());
        const std::int64_t got = read_at(file_.get(), from, bytes.first(of_file));
        if (got != static_cast<std::int64_t>(of_file)) {
            return failed(got < 0 ? errno : EIO);
        }
        from = spilled_;
    }
    memory_.copy(bytes.data() + of_file, bytes.size() - of_file,
                 static_cast<std::size_t>(from - spilled_));
    return {};
}

Status TrackSpool::append(const Track& rows) {
    blocks_.push_back({rows_, rows.rows(), spilled_ + static_cast<std::int64_t>(memory_.size())});
    for (std::size_t column = 0; column < track_number_columns; ++column) {
        TRY(write(std::as_bytes(track_column(rows, column))));
    }
    rows_ += rows.rows();
    return write(std::as_bytes(rows.flags()));
}

Status TrackSpool::numbers(std::size_t column, const NumberSink& sink) const {
    std::vector<double> piece;
    for (const Block& block : blocks_) {
        piece.resize(block.rows);
        TRY(read(block.place_of(column), std::as_writable_bytes(std::span(piece))));
        TRY(sink(piece));
    }
    return {};
}

Status TrackSpool::flags(const FlagSink& sink) const {
    std::vector<Flags> piece;
    for (const Block& block : blocks_) {
        piece.resize(block.rows);
        TRY(read_flags(block, piece));
        TRY(sink(piece));
    }
    return {};
}

Status TrackSpool::whole_rows(std::size_t at_once, const TrackSink& sink) const {
    for (std::size_t k = 0; k < blocks_.size();) {
        Track track;
        do {
            const Block& block = blocks_[k++];
            Track rows(block.rows);
            for (std::size_t column = 0; column < track_number_columns; ++column) {
                TRY(read(block.place_of(column),
                         std::as_writable_bytes(track_column(rows, column))));
            }
            TRY(read_flags(block, rows.flags()));
            track.append(rows);
        } while (k < blocks_.size() && track.rows() + blocks_[k].rows <= at_once);
        TRY(sink(track));
    }
    return {};
}

Status TrackSpool::read_flags(const Block& block, std::span<Flags> flags) const {
    const Status done = read(block.place_of(track_number_columns), std::as_writable_bytes(flags));
    set_flags(flags, block.first, flagged_);
    return done;
}

}  // namespace vybeg
