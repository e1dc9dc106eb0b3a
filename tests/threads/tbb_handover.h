#pragma once

// Included before the sources that use oneTBB in the build for ThreadSanitizer (preset tsan), which
// does not see how the uninstrumented libtbb hands work from thread to thread, and would report all
// of it as races. Here parallel_for(), make_filter() and parallel_pipeline() show it: what happens
// before a body runs in another thread, and what happens after it. Nothing else is ordered by it,
// so that two bodies that run at the same time still race.

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_pipeline.h>

#include <memory>
#include <sanitizer/tsan_interface.h>
#include <type_traits>
#include <utility>

namespace vybeg::threads {

inline void give(const void* place) {
    if (place) {
        __tsan_release(const_cast<void*>(place));
    }
}

inline void take(const void* place) {
    if (place) {
        __tsan_acquire(const_cast<void*>(place));
    }
}

// From the caller to every body, and from every body to the caller.
struct Loop {
    char begin = 0;
    char end = 0;
};

// A place of its own for what a pipeline or a filter hands over. It stays: filters are copied, and
// end, where no other thread may see it yet.
inline const char* new_place() {
    return new char;
}

// Of the pipeline whose filters this thread makes: from the caller to the first stage and from the
// last to the caller; and, as their number is limited, from the tokens that have left to those that
// enter.
inline const char*& tokens_in_the_making() {
    thread_local const char* tokens = nullptr;
    if (!tokens) {
        tokens = new_place();
    }
    return tokens;
}

// Where what a filter hands to the next one lies.
template <class T>
const void* place_of(T* token) {
    return token;
}
template <class T>
const void* place_of(const std::shared_ptr<T>& token) {
    return token.get();
}

}  // namespace vybeg::threads

namespace tbb {

template <class Index, class Body>
void vybeg_parallel_for(const Index& first, const Index& last, const Body& body) {
    vybeg::threads::Loop loop;
    vybeg::threads::give(&loop.begin);
    tbb::parallel_for(first, last, [&](const Index& index) {
        vybeg::threads::take(&loop.begin);
        body(index);
        vybeg::threads::give(&loop.end);
    });
    vybeg::threads::take(&loop.end);
}

template <class Range, class Body>
void vybeg_parallel_for(const Range& range, const Body& body) {
    vybeg::threads::Loop loop;
    vybeg::threads::give(&loop.begin);
    tbb::parallel_for(range, [&](const Range& part) {
        vybeg::threads::take(&loop.begin);
        body(part);
        vybeg::threads::give(&loop.end);
    });
    vybeg::threads::take(&loop.end);
}

template <class In, class Out, class Body>
filter<In, Out> vybeg_make_filter(filter_mode mode, const Body& body) {
    using vybeg::threads::give;
    using vybeg::threads::place_of;
    using vybeg::threads::take;
    const char* const tokens = vybeg::threads::tokens_in_the_making();
    const bool serial = mode != filter_mode::parallel;
    const char* const own = vybeg::threads::new_place();  // from one serial run to the next
    const auto enter = [=] {
        if (serial) {
            take(own);
        }
    };
    const auto leave = [=] {
        if (serial) {
            give(own);
        }
    };
    if constexpr (std::is_void_v<In>) {
        return tbb::make_filter<In, Out>(mode, [=](flow_control& flow) -> Out {
            take(tokens);
            enter();
            Out token = body(flow);
            leave();
            give(place_of(token));
            give(tokens);  // the last run only stops the flow
            return token;
        });
    } else if constexpr (std::is_void_v<Out>) {
        return tbb::make_filter<In, Out>(mode, [=](const In& token) {
            take(place_of(token));
            enter();
            body(token);
            leave();
            give(tokens);
        });
    } else {
        return tbb::make_filter<In, Out>(mode, [=](const In& token) -> Out {
            take(place_of(token));
            enter();
            Out next = body(token);
            leave();
            give(place_of(next));
            return next;
        });
    }
}

inline void vybeg_parallel_pipeline(std::size_t most_tokens, const filter<void, void>& filters) {
    const char* const tokens = std::exchange(vybeg::threads::tokens_in_the_making(), nullptr);
    vybeg::threads::give(tokens);
    tbb::parallel_pipeline(most_tokens, filters);
    vybeg::threads::take(tokens);
}

}  // namespace tbb

#define parallel_for vybeg_parallel_for
#define make_filter vybeg_make_filter
#define parallel_pipeline vybeg_parallel_pipeline
