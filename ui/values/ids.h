#pragma once

namespace vybeg::ui {

// The identity of recordings, analyses and sets of a document. All numbers come from one
// counter (IdCounter).
enum class RecordingId : int { none = 0 };
enum class AnalysisId : int { none = 0 };
enum class SetId : int { none = 0 };

// The number of an id: of its background jobs (BackgroundJobs), in item data, in dragged data.
template <class Id>
constexpr int number(Id id) {
    return static_cast<int>(id);
}

// Gives the recordings, analyses, sets and requests of a document their numbers, each only once.
class IdCounter {
public:
    template <class Id = int>
    Id next() {
        return static_cast<Id>(++last_);
    }

private:
    int last_ = 0;
};

}  // namespace vybeg::ui
