#pragma once

namespace vybeg::ui {

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
