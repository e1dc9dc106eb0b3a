#include "core/recording/bytes/inflated_part.h"

#include "core/base/guarded.h"

#include <algorithm>
#include <deque>
#include <utility>
#include <vector>
#include <zlib.h>

namespace vybeg {
namespace {

constexpr std::int64_t packed_at_once = std::int64_t{1} << 16;
constexpr std::int64_t skipped_at_once = std::int64_t{1} << 16;
constexpr std::int64_t recent_spacing = std::int64_t{1} << 20;
constexpr std::size_t recent_states = 8;   // for windows that overlap
constexpr std::size_t spread_states = 64;  // for jumps

// zlib's decoder at one position of the stream. It owns no packed bytes; `packed` counts those
// consumed.
class Inflater {
public:
    Inflater() { inflateInit2(&stream_, -MAX_WBITS); }  // raw: ZIP has no zlib header
    Inflater(const Inflater& other) : position_(other.position_), crc_(other.crc_) {
        packed_ = other.packed_ - other.stream_.avail_in;
        inflateCopy(&stream_, const_cast<z_stream*>(&other.stream_));
        stream_.avail_in = 0;
        stream_.next_in = nullptr;
    }
    Inflater& operator=(const Inflater&) = delete;
    ~Inflater() { inflateEnd(&stream_); }

    std::int64_t position() const { return position_; }
    std::uint32_t crc() const { return crc_; }

    // Unpacks the next bytes and returns their number, smaller than out.size() only at the end of
    // the stream or, with `damaged`, at a fault.
    Result<std::int64_t> next(const FileBytes& file, const DeflatedPart& part, std::span<char> out,
                              bool& damaged) {
        stream_.next_out = reinterpret_cast<Bytef*>(out.data());
        stream_.avail_out = static_cast<uInt>(out.size());
        int state = Z_OK;
        while (stream_.avail_out > 0 && state == Z_OK) {
            if (stream_.avail_in == 0) {
                TRY(refill(file, part));
            }
            state = inflate(&stream_, Z_NO_FLUSH);
        }
        damaged = state != Z_OK && state != Z_STREAM_END;
        const std::int64_t got = static_cast<std::int64_t>(out.size()) - stream_.avail_out;
        crc_ = static_cast<std::uint32_t>(
            ::crc32(crc_, reinterpret_cast<const Bytef*>(out.data()), static_cast<uInt>(got)));
        position_ += got;
        return got;
    }

private:
    // At the end of the file there is no input, and inflate() reports that it needs more.
    Status refill(const FileBytes& file, const DeflatedPart& part) {
        const std::int64_t size = std::min(part.packed_size - packed_, packed_at_once);
        buffer_.resize(static_cast<std::size_t>(size));
        const auto got = TRY(file.read(part.offset + packed_, buffer_));
        packed_ += got;
        stream_.next_in = reinterpret_cast<Bytef*>(buffer_.data());
        stream_.avail_in = static_cast<uInt>(got);
        return {};
    }

    z_stream stream_{};
    std::vector<char> buffer_;
    std::int64_t packed_ = 0;
    std::int64_t position_ = 0;
    std::uint32_t crc_ = 0;
};

// The part's decoder, and copies of it at places that it has passed.
class Decoders {
public:
    Decoders(std::shared_ptr<const FileBytes> file, DeflatedPart part)
        : file_(std::move(file)),
          part_(std::move(part)),
          spacing_(std::max(recent_spacing,
                            part_.size / static_cast<std::int64_t>(spread_states) + 1)) {}

    Status read(std::int64_t offset, std::span<char> out) {
        go_near(offset);
        std::vector<char> skipped(
            static_cast<std::size_t>(std::min(offset - now_->position(), skipped_at_once)));
        while (now_->position() < offset) {
            const std::int64_t count =
                std::min<std::int64_t>(offset - now_->position(), skipped_at_once);
            const auto some = std::span(skipped).first(static_cast<std::size_t>(count));
            TRY(unpack(some));
        }
        for (std::size_t done = 0; done < out.size();) {
            const std::size_t count =
                std::min<std::size_t>(out.size() - done, static_cast<std::size_t>(recent_spacing));
            TRY(unpack(out.subspan(done, count)));
            done += count;
        }
        return {};
    }

private:
    // Moves the decoder to the nearest stored state at or before the offset.
    void go_near(std::int64_t offset) {
        const Inflater* best =
            now_ && !failed_ && now_->position() <= offset ? now_.get() : nullptr;
        for (const auto* states : {&recent_, &spread_}) {
            for (const auto& state : *states) {
                if (state->position() <= offset &&
                    (!best || state->position() > best->position())) {
                    best = state.get();
                }
            }
        }
        if (!best) {
            now_ = std::make_unique<Inflater>();
        } else if (best != now_.get()) {
            now_ = std::make_unique<Inflater>(*best);
        }
        failed_ = false;
    }

    // Unpacks out.size() bytes and verifies the checksum after the last ones.
    Status unpack(std::span<char> out) {
        remember();
        bool damaged = false;
        const auto got = now_->next(*file_, part_, out, damaged);
        failed_ = true;  // until success is known
        if (!got) {
            return got.error();
        }
        if (damaged || *got < static_cast<std::int64_t>(out.size())) {
            return error(VYBEG_MESSAGE("Words", "its packed data are wrong or end early"));
        }
        if (now_->position() == part_.size && part_.crc32.value_or(now_->crc()) != now_->crc()) {
            return error(VYBEG_MESSAGE("Words", "its checksum is wrong"));
        }
        failed_ = false;
        return {};
    }

    void remember() {
        const std::int64_t position = now_->position();
        if (recent_.empty() || position >= recent_.back()->position() + recent_spacing ||
            position + recent_spacing <= recent_.front()->position()) {
            recent_.push_back(std::make_unique<Inflater>(*now_));
            if (recent_.size() > recent_states) {
                recent_.pop_front();
            }
        }
        if (spread_.empty() || position >= spread_.back()->position() + spacing_) {
            spread_.push_back(std::make_unique<Inflater>(*now_));
        }
    }

    Error error(const char* text) const {
        return file_->error(ErrorCode::format_damaged,
                            {part_.format, words("%1: %2", {part_.name, words(text)})});
    }

    std::shared_ptr<const FileBytes> file_;
    DeflatedPart part_;
    std::int64_t spacing_;  // bytes between the states spread over the whole part
    std::unique_ptr<Inflater> now_;
    bool failed_ = false;
    std::deque<std::unique_ptr<const Inflater>> recent_;
    std::deque<std::unique_ptr<const Inflater>> spread_;  // positions rise
};

class InflatedPart final : public ByteSource {
public:
    InflatedPart(std::shared_ptr<const FileBytes> file, DeflatedPart part)
        : size_(part.size), decoders_(std::move(file), std::move(part)) {}

    std::int64_t size() const override { return size_; }
    bool seeks() const override { return false; }

    Status read(std::int64_t offset, std::span<char> out) const override {
        return decoders_.hold()->read(offset, out);
    }

private:
    std::int64_t size_;
    Guarded<Decoders> decoders_;
};

}  // namespace

std::shared_ptr<const ByteSource> inflated_part(std::shared_ptr<const FileBytes> file,
                                                DeflatedPart part) {
    return std::make_shared<InflatedPart>(std::move(file), std::move(part));
}

}  // namespace vybeg
