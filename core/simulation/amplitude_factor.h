#pragma once

#include "core/simulation/free_decay.h"
#include "core/simulation/slow_motion.h"

namespace vybeg {

// Whether friction or a drive changes the amplitude.
bool has_amplitude_factor(const FreeDecay& decay);

// Factor A of the linear motion w = exp(M t) z(0), z = A w, under friction and a drive, which leave
// the shape of the wave as it is:
//     dA/dt = g(t) A - dry/|w| - air A^2 |w|        A = 0 from the instant at which the wave rests
// by Runge and Kutta's fourth order, in steps of 0.5 % of the fastest change, and cubics between
// them: errors below 1e-10.
class AmplitudeFactor {
public:
    AmplitudeFactor(const FreeDecay& decay, const SlowMotion& linear);

    // A at t, seconds; 1 before the start. Ascending times.
    double at(double t);

private:
    double slope(double t, double factor) const;
    double size_of_linear(double t) const;
    double next_switch() const;
    void advance();

    double dry_;
    double air_;
    double drive_;
    double from_s_;
    double to_s_;
    SlowMotion linear_;
    double slowest_;  // rate of change of the linear motion, 1/s
    double least_;    // amplitude of a wave at rest
    struct Node {
        double time_s = 0;
        double factor = 1;
        double slope = 0;
    };
    double time_s_ = 0;  // start of the step
    Node begin_;
    Node end_;
};

}  // namespace vybeg
