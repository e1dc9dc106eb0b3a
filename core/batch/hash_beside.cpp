#include "core/batch/hash_beside.h"

#include "core/base/job_control.h"
#include "core/recording/bytes/sha256.h"
#include "core/recording/samples/file_changes.h"

#include <utility>

namespace vybeg {
namespace {

std::future<Result<std::string>> hash_of(const Recording& recording, int threads,
                                         std::stop_token stop) {
    prepare_sha256();
    return std::async(threads == 1 ? std::launch::deferred : std::launch::async,
                      [&recording, job = JobControl(std::move(stop))] {
                          return recording_sha256(recording, job);
                      });
}

}  // namespace

HashBeside::HashBeside(const Recording& recording, int threads, std::stop_token stop)
    : interrupted_(std::move(stop), [this] { given_up_.request_stop(); }),
      hash_(hash_of(recording, threads, given_up_.get_token())) {}

}  // namespace vybeg
