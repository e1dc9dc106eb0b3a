#include "core/recording/bytes/packed_parts.h"

#include "core/base/guarded.h"
#include "core/base/message_arg.h"
#include "core/recording/bytes/number_type.h"

#include <algorithm>
#include <cerrno>
#include <deque>
#include <limits>
#include <span>
#include <sys/mman.h>
#include <unistd.h>
#include <utility>
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

namespace {

using namespace std::string_view_literals;

// Signatures and least sizes of the records.
constexpr std::string_view end_signature = "PK\x05\x06"sv;
constexpr std::int64_t end_size = 22;
constexpr std::string_view locator64_signature = "PK\x06\x07"sv;
constexpr std::int64_t locator64_size = 20;
constexpr std::string_view end64_signature = "PK\x06\x06"sv;
constexpr std::int64_t end64_size = 56;
constexpr std::string_view entry_signature = "PK\x01\x02"sv;
constexpr std::size_t entry_size = 46;
constexpr std::string_view local_signature = "PK\x03\x04"sv;
constexpr std::int64_t local_size = 30;

constexpr std::size_t most_members = 10000;
constexpr std::int64_t longest_comment = 65535;
constexpr std::uint16_t zip64_extra = 1;
constexpr std::uint32_t in_extra = 0xFFFFFFFF;  // the number is in the ZIP64 extra field

template <class Number>
Number number_at(std::string_view bytes, std::size_t at) {
    return load<Number>(bytes.data() + at, false);
}

// A 64 bit length or position; -1 beyond the largest file size.
std::int64_t length_at(std::string_view bytes, std::size_t at) {
    const auto number = number_at<std::uint64_t>(bytes, at);
    constexpr std::uint64_t most = std::numeric_limits<std::int64_t>::max() / 2;
    return number > most ? -1 : static_cast<std::int64_t>(number);
}

struct Directory {
    std::int64_t offset = 0;
    std::int64_t size = 0;
};

// Position of the directory of a ZIP64 archive; empty for other archives.
Result<std::optional<Directory>> find_directory64(const FileBytes& file, std::int64_t end_offset) {
    if (end_offset < locator64_size) {
        return std::optional<Directory>{};
    }
    const auto locator = TRY(file.text(end_offset - locator64_size, locator64_size));
    if (!locator.starts_with(locator64_signature)) {
        return std::optional<Directory>{};
    }
    const std::int64_t at = length_at(locator, 8);
    if (at < 0 || at > file.size() - end64_size) {
        return file.damaged("ZIP", VYBEG_MESSAGE("Words", "its directory lies outside of it"));
    }
    const auto end = TRY(file.text(at, end64_size));
    if (!end.starts_with(end64_signature)) {
        return file.damaged("ZIP", VYBEG_MESSAGE("Words", "its directory cannot be found"));
    }
    return std::optional(Directory{length_at(end, 48), length_at(end, 40)});
}

Result<Directory> find_directory(const FileBytes& file) {
    const std::int64_t tail_size = std::min(file.size(), end_size + longest_comment);
    const auto tail = TRY(file.text(file.size() - tail_size, tail_size));
    const std::size_t last = static_cast<std::size_t>(std::max(tail_size - end_size, {}));
    const std::size_t at = tail.rfind(end_signature, last);
    if (tail_size < end_size || at == tail.npos) {
        return file.damaged(
            "ZIP",
            VYBEG_MESSAGE("Words", "the directory at its end is missing; the file was cut off"));
    }
    const std::int64_t end_offset = file.size() - tail_size + static_cast<std::int64_t>(at);
    const auto found = TRY(find_directory64(file, end_offset));
    const Directory directory = found ? *found
                                      : Directory{number_at<std::uint32_t>(tail, at + 16),
                                                  number_at<std::uint32_t>(tail, at + 12)};
    if (directory.offset < 0 || directory.size < 0 || directory.offset > file.size() ||
        directory.size > file.size() - directory.offset) {
        return file.damaged("ZIP", VYBEG_MESSAGE("Words", "its directory lies outside of it"));
    }
    return directory;
}

// Reads the numbers beyond 32 bits from the extra field, in this order. False if they are missing.
bool take_extra(std::string_view extra, ZipMember& member) {
    while (extra.size() >= 4) {
        const auto id = number_at<std::uint16_t>(extra, 0);
        const std::size_t size = number_at<std::uint16_t>(extra, 2);
        std::string_view field = extra.substr(4, size);
        if (field.size() < size) {
            return false;
        }
        extra.remove_prefix(4 + size);
        if (id != zip64_extra) {
            continue;
        }
        for (std::int64_t* value : {&member.size, &member.packed_size, &member.header_offset}) {
            if (*value == in_extra) {
                if (field.size() < 8) {
                    return false;
                }
                *value = length_at(field, 0);
                field.remove_prefix(8);
            }
        }
        return true;
    }
    return true;
}

}  // namespace

bool is_zip(std::string_view head) {
    return head.starts_with(local_signature);
}

Result<std::vector<ZipMember>> zip_members(const FileBytes& file) {
    const auto directory = TRY(find_directory(file));
    const auto bytes = TRY(file.text(directory.offset, directory.size));
    std::vector<ZipMember> members;
    for (std::string_view rest = bytes; rest.starts_with(entry_signature);) {
        if (rest.size() < entry_size) {
            return file.damaged("ZIP",
                                VYBEG_MESSAGE("Words", "its directory ends within an entry"));
        }
        const std::size_t name_size = number_at<std::uint16_t>(rest, 28);
        const std::size_t extra_size = number_at<std::uint16_t>(rest, 30);
        const std::size_t comment_size = number_at<std::uint16_t>(rest, 32);
        const std::size_t size = entry_size + name_size + extra_size + comment_size;
        if (rest.size() < size) {
            return file.damaged("ZIP",
                                VYBEG_MESSAGE("Words", "its directory ends within an entry"));
        }
        ZipMember member;
        member.name = rest.substr(entry_size, name_size);
        member.encrypted = (number_at<std::uint16_t>(rest, 8) & 1) != 0;
        member.method = number_at<std::uint16_t>(rest, 10);
        member.crc32 = number_at<std::uint32_t>(rest, 16);
        member.packed_size = number_at<std::uint32_t>(rest, 20);
        member.size = number_at<std::uint32_t>(rest, 24);
        member.header_offset = number_at<std::uint32_t>(rest, 42);
        if (!take_extra(rest.substr(entry_size + name_size, extra_size), member)) {
            return file.damaged("ZIP",
                                VYBEG_MESSAGE("Words", "an entry of its directory is incomplete"));
        }
        if (members.size() == most_members) {
            return too_many_parts(file.path().string(), "ZIP",
                                  VYBEG_MESSAGE("Words", "it has more than %1 members"),
                                  most_members);
        }
        if (!member.name.ends_with('/')) {
            members.push_back(std::move(member));
        }
        rest.remove_prefix(size);
    }
    return members;
}

Result<std::shared_ptr<const ByteSource>> zip_content(std::shared_ptr<const FileBytes> file,
                                                      const ZipMember& member) {
    constexpr int stored = 0;
    constexpr int deflated = 8;
    if (member.encrypted) {
        return file->unsupported("ZIP", VYBEG_MESSAGE("Words", "encrypted members"));
    }
    if (member.method != stored && member.method != deflated) {
        return file->unsupported("ZIP", VYBEG_MESSAGE("Words", "members packed by method %1"),
                                 {count_arg(member.method)});
    }
    const auto outside = [&] {
        return file->damaged("ZIP", VYBEG_MESSAGE("Words", "%1 lies outside of it"), {member.name});
    };
    if (member.header_offset < 0 || member.header_offset > file->size() - local_size) {
        return outside();
    }
    const auto header = TRY(file->text(member.header_offset, local_size));
    if (static_cast<std::int64_t>(header.size()) < local_size ||
        !header.starts_with(local_signature)) {
        return file->damaged("ZIP", VYBEG_MESSAGE("Words", "%1 is not where its directory says"),
                             {member.name});
    }
    const std::int64_t offset = member.header_offset + local_size +
                                number_at<std::uint16_t>(header, 26) +
                                number_at<std::uint16_t>(header, 28);
    if (offset > file->size() || member.packed_size < 0 ||
        member.packed_size > file->size() - offset) {
        return outside();
    }
    if (member.method == stored) {
        return file_part(file, offset, member.packed_size);
    }
    if (member.size < 0 || member.size / best_ratio > member.packed_size) {
        return file->damaged("ZIP",
                             VYBEG_MESSAGE("Words", "%1 cannot be as long as its directory says"),
                             {member.name});
    }
    return inflated_part(
        file, {offset, member.packed_size, member.size, member.crc32, "NPZ", member.name});
}

Result<std::shared_ptr<const FileBytes>> zip_file(std::shared_ptr<const FileBytes> file,
                                                  const ZipMember& member) {
    const auto content = TRY(zip_content(file, member));
    Descriptor copy(::memfd_create("member", MFD_CLOEXEC));
    std::vector<char> block(std::size_t{1} << 20);
    for (std::int64_t at = 0; copy && at < content->size();) {
        const auto part = std::span(block).first(static_cast<std::size_t>(
            std::min<std::int64_t>(static_cast<std::int64_t>(block.size()), content->size() - at)));
        TRY(content->read(at, part));
        const ssize_t put = ::write(copy.get(), part.data(), part.size());
        if (put < 0) {
            return file->error(ErrorCode::file_read_failed, {system_reason(errno)});
        }
        at += put;
    }
    return FileBytes::adopt(file->path(), std::move(copy));
}

}  // namespace vybeg
