#include "core/output/track_spool.h"

namespace vybeg {

Status TrackSpool::append(const Track& rows) {
    blocks_.push_back({rows_, rows.rows(), bytes_});
    for (std::size_t column = 0; column < track_number_columns; ++column) {
        TRY(spool_.write(std::as_bytes(track_column(rows, column))));
    }
    rows_ += rows.rows();
    bytes_ += static_cast<std::int64_t>(rows.rows() *
                                        (track_number_columns * sizeof(double) + sizeof(Flags)));
    return spool_.write(std::as_bytes(rows.flags()));
}

Status TrackSpool::numbers(std::size_t column, const NumberSink& sink) const {
    std::vector<double> piece;
    for (const Block& block : blocks_) {
        piece.resize(block.rows);
        TRY(spool_.read(block.place_of(column), std::as_writable_bytes(std::span(piece))));
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
            Track rows(blocks_[k].rows);
            TRY(read_block(blocks_[k++], rows));
            track.append(rows);
        } while (k < blocks_.size() && track.rows() + blocks_[k].rows <= at_once);
        TRY(sink(track));
    }
    return {};
}

Status TrackSpool::read_flags(const Block& block, std::span<Flags> flags) const {
    const Status read =
        spool_.read(block.place_of(track_number_columns), std::as_writable_bytes(flags));
    set_flags(flags, block.first, flagged_);
    return read;
}

Status TrackSpool::read_block(const Block& block, Track& rows) const {
    for (std::size_t column = 0; column < track_number_columns; ++column) {
        TRY(spool_.read(block.place_of(column),
                        std::as_writable_bytes(track_column(rows, column))));
    }
    return read_flags(block, rows.flags());
}

}  // namespace vybeg
