#pragma once

#include <algorithm>
#include <atomic>
#include <thread>
#include <vector>

namespace vybeg::test {

// Calls use(0) to use(count - 1), on as many threads as there are processors. (oneTBB's headers and
// Qt's keyword `emit` do not go together.)
template <class Use>
void for_each_seed(int count, const Use& use) {
    std::atomic<int> next = 0;
    std::vector<std::jthread> threads;
    for (unsigned k = 0; k < std::max(1U, std::thread::hardware_concurrency()); ++k) {
        threads.emplace_back([&] {
            for (int seed = next++; seed < count; seed = next++) {
                use(seed);
            }
        });
    }
}

}  // namespace vybeg::test
