#pragma once

#include <QElapsedTimer>
#include <QString>

#include <cstddef>
#include <optional>

namespace vybeg::ui {

// How far a batch is, and how long it still takes: as long for each set as for those of this batch.
class BatchProgress {
public:
    void begin(std::size_t sets);
    // `kept`: a row of an earlier batch, which took no time.
    void add(bool kept);

    std::size_t sets() const { return sets_; }
    // Nothing before the first row of this batch, and at the end.
    std::optional<double> secondsLeft() const;

private:
    std::size_t sets_ = 0;
    std::size_t done_ = 0;
    std::size_t computed_ = 0;
    qint64 last_row_ms_ = 0;
    QElapsedTimer since_;
};

// "40 s", "12 min", "3.5 h".
QString durationText(double seconds);

}  // namespace vybeg::ui
