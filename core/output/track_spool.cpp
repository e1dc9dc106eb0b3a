#include "core/output/track_spool.h"

namespace vybeg {

Status TrackSpool::append(const Track& rows) {
    blocks_.push_back({rows_, rows.rows(), bytes_});
    Status written;
    for (std::size_t column = 0; column < track_number_columns && written; ++column) {
        written = spool_.write(std::as_bytes(track_column(rows, column)));
    }
    rows_ += rows.rows();
    bytes_ += static_cast<std::int64_t>(rows.rows() *
                                        (track_number_columns * sizeof(double) + sizeof(Flags)));
    return written ? spool_.write(std::as_bytes(rows.flags())) : written;
}

Status TrackSpool::numbers(std::size_t column, const NumberSink& sink) const {
    std::vector<double> piece;
    Status taken;
    for (std::size_t k = 0; k < blocks_.size() && taken; ++k) {
        piece.resize(blocks_[k].rows);
        taken = spool_.read(blocks_[k].place_of(column), std::as_writable_bytes(std::span(piece)));
        taken = taken ? sink(piece) : taken;
    }
    return taken;
}

Status TrackSpool::flags(const FlagSink& sink) const {
    std::vector<Flags> piece;
    Status taken;
    for (std::size_t k = 0; k < blocks_.size() && taken; ++k) {
        piece.resize(blocks_[k].rows);
        taken = read_flags(blocks_[k], piece);
        taken = taken ? sink(piece) : taken;
    }
    return taken;
}

Status TrackSpool::whole_rows(std::size_t at_once, const TrackSink& sink) const {
    Status taken;
    for (std::size_t k = 0; k < blocks_.size() && taken;) {
        Track track;
        do {
            Track rows(blocks_[k].rows);
            taken = read_block(blocks_[k++], rows);
            track.append(rows);
        } while (taken && k < blocks_.size() && track.rows() + blocks_[k].rows <= at_once);
        taken = taken ? sink(track) : taken;
    }
    return taken;
}

Status TrackSpool::read_flags(const Block& block, std::span<Flags> flags) const {
    const Status read =
        spool_.read(block.place_of(track_number_columns), std::as_writable_bytes(flags));
    set_flags(flags, block.first, flagged_);
    return read;
}

Status TrackSpool::read_block(const Block& block, Track& rows) const {
    Status read;
    for (std::size_t column = 0; column < track_number_columns && read; ++column) {
        read =
            spool_.read(block.place_of(column), std::as_writable_bytes(track_column(rows, column)));
    }
    return read ? read_flags(block, rows.flags()) : read;
}

}  // namespace vybeg
