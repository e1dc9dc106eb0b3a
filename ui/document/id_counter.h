#pragma once

namespace vybeg::ui {

// Recordings, runs, sets and requests of a document are told apart by numbers from one counter.
class IdCounter {
public:
    int next() { return ++last_; }

private:
    int last_ = 0;
};

}  // namespace vybeg::ui
