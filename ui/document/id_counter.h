#pragma once

namespace vybeg::ui {

// Recordings, analyses, sets and requests of a document are told apart by numbers from one counter.
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
