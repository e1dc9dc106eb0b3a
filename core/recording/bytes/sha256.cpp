#include "core/recording/bytes/sha256.h"

#include <openssl/evp.h>

#include <array>
#include <memory>
#include <vector>

namespace vybeg {
namespace {

Error not_available(const std::string& where) {
    return {
        ErrorCode::file_read_failed, where, {Phrase::tr("SHA-256 is not available in OpenSSL")}};
}

std::string hexadecimal(std::span<const unsigned char> digest) {
    std::string text;
    for (const unsigned char byte : digest) {
        text += "0123456789abcdef"[byte >> 4];
        text += "0123456789abcdef"[byte & 15];
    }
    return text;
}

}  // namespace

Result<std::string> text_sha256(std::string_view text) {
    std::array<unsigned char, EVP_MAX_MD_SIZE> digest;
    unsigned int length = 0;
    if (EVP_Digest(text.data(), text.size(), digest.data(), &length, EVP_sha256(), nullptr) != 1) {
        return not_available("");
    }
    return hexadecimal(std::span(digest).first(length));
}

void prepare_sha256() {
    (void)text_sha256("");
}

Result<std::string> files_sha256(std::span<const FileBytes* const> files, const JobControl& job) {
    const std::string where = files.front()->path().string();
    const std::unique_ptr<EVP_MD_CTX, decltype(&EVP_MD_CTX_free)> context(EVP_MD_CTX_new(),
                                                                          &EVP_MD_CTX_free);
    if (!context) {  // which the other functions would dereference
        return Error{ErrorCode::out_of_memory, where, {}};
    }
    bool ok = EVP_DigestInit_ex(context.get(), EVP_sha256(), nullptr) == 1;
    std::vector<char> chunk(std::size_t{1} << 20);
    std::int64_t size = 0;
    for (const FileBytes* file : files) {
        size += file->size();
    }
    std::int64_t done = 0;
    for (const FileBytes* file : files) {
        for (std::int64_t offset = 0; ok && offset < file->size();) {
            TRY(job.go_on());
            const auto got = TRY(file->read(offset, chunk));
            if (got == 0) {
                break;
            }
            ok = EVP_DigestUpdate(context.get(), chunk.data(), static_cast<std::size_t>(got)) == 1;
            offset += got;
            done += got;
            job.report(static_cast<double>(done) / static_cast<double>(size));
        }
    }
    std::array<unsigned char, EVP_MAX_MD_SIZE> digest;
    unsigned int length = 0;
    if (!ok || EVP_DigestFinal_ex(context.get(), digest.data(), &length) != 1) {
        return not_available(where);
    }
    return hexadecimal(std::span(digest).first(length));
}

Result<std::string> file_sha256(const std::filesystem::path& path, const JobControl& job) {
    const auto file = FileBytes::open(path);
    if (!file) {
        return file.error().code == ErrorCode::file_empty ? text_sha256("") : file.error();
    }
    return files_sha256(std::array{file->get()}, job);
}

void add_parts(std::string& text, const std::vector<std::string>& parts) {
    for (const std::string& part : parts) {
        text += std::to_string(part.size()) + ":" + part;
    }
}

}  // namespace vybeg
