#include "core/recording/bytes/byte_source.h"

#include <utility>

namespace vybeg {
namespace {

class FilePart final : public ByteSource {
public:
    FilePart(std::shared_ptr<const FileBytes> file, std::int64_t offset, std::int64_t size)
        : file_(std::move(file)), offset_(offset), size_(size) {}

    std::int64_t size() const override { return size_; }

    Status read(std::int64_t offset, std::span<char> out) const override {
        const auto got = TRY(file_->read(offset_ + offset, out));
        if (got < static_cast<std::int64_t>(out.size())) {
            return file_->error(
                ErrorCode::file_read_failed,
                {words(VYBEG_MESSAGE("Words", "the file became shorter while it was read"))});
        }
        return {};
    }

private:
    std::shared_ptr<const FileBytes> file_;
    std::int64_t offset_;
    std::int64_t size_;
};

}  // namespace

std::shared_ptr<const ByteSource> file_part(std::shared_ptr<const FileBytes> file,
                                            std::int64_t offset, std::int64_t size) {
    return std::make_shared<FilePart>(std::move(file), offset, size);
}

}  // namespace vybeg
