#pragma once

#include "core/base/result.h"
#include "core/recording/samples/recording.h"

#include <functional>
#include <future>
#include <stop_token>
#include <string>

namespace vybeg {

// The hash of a recording, made beside other work by a thread of its own, or, where there is to be
// one thread alone, when it is asked for. The thread stops where the object goes.
class HashBeside {
public:
    HashBeside(const Recording& recording, int threads, std::stop_token stop);
    ~HashBeside() { given_up_.request_stop(); }
    HashBeside(const HashBeside&) = delete;
    HashBeside& operator=(const HashBeside&) = delete;

    Result<std::string> get() { return hash_.get(); }

private:
    std::stop_source given_up_;
    std::stop_callback<std::function<void()>> interrupted_;
    std::future<Result<std::string>> hash_;
};

}  // namespace vybeg
