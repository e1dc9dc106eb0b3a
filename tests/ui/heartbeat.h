#pragma once

#include <QElapsedTimer>
#include <QFile>
#include <QObject>
#include <QString>
#include <QTimer>

#include <algorithm>

namespace vybeg::ui {

// Listens to the event loop through a timer of 5 ms and keeps the longest time between two of its
// signals.
//
// Time in which the thread was ready to run but the kernel let others run (run_delay of
// /proc/thread-self/schedstat) does not count, so that a busy machine fails no test: what counts is
// all that the window itself keeps its thread with, computing as well as waiting for locks, other
// threads and disks, which the thread's processor time would not show. Where the kernel does not
// tell the delay, it counts.
class Heartbeat : public QObject {
public:
    Heartbeat() {
        timer_.setTimerType(Qt::PreciseTimer);
        timer_.setInterval(5);
        connect(&timer_, &QTimer::timeout, this, &Heartbeat::beat);
        reset();
        timer_.start();
    }

    void reset() {
        clock_.start();
        delay_ms_ = readDelay();
        longest_ms_ = longest_with_delay_ms_ = 0;
        beats_ = 0;
    }

    double longestMs() const { return longest_ms_; }
    int beats() const { return beats_; }
    QString text() const {
        return QStringLiteral("longest gap %1 ms (%2 ms with the time others ran), %3 beats")
            .arg(longest_ms_, 0, 'f', 1)
            .arg(longest_with_delay_ms_, 0, 'f', 1)
            .arg(beats_);
    }

    // Milliseconds that this thread has waited for a processor.
    static double readDelay() {
        QFile file(QStringLiteral("/proc/thread-self/schedstat"));
        if (!file.open(QIODevice::ReadOnly)) {
            return 0;
        }
        return 1e-6 * file.readAll().split(' ').value(1).toDouble();
    }

private:
    void beat() {
        const double wall_ms = 1e-6 * static_cast<double>(clock_.nsecsElapsed());
        const double delay_ms = readDelay();
        longest_ms_ = std::max(longest_ms_, wall_ms - (delay_ms - delay_ms_));
        longest_with_delay_ms_ = std::max(longest_with_delay_ms_, wall_ms);
        delay_ms_ = delay_ms;
        clock_.start();
        ++beats_;
    }

    QTimer timer_;
    QElapsedTimer clock_;
    double delay_ms_ = 0;
    double longest_ms_ = 0;
    double longest_with_delay_ms_ = 0;
    int beats_ = 0;
};

}  // namespace vybeg::ui
