#include "core/resonator/reason.h"

#include "core/base/messages.h"

// Marks a text for lupdate, as in core/base/messages.cpp.
#define VYBEG_MESSAGE(context, text) text

namespace vybeg {

const char* message_template(ReasonCode code) {
    switch (code) {
        case ReasonCode::none: return "";
        case ReasonCode::one_direction:
            return VYBEG_MESSAGE("Reason",
                                 "The wave hardly moves, so that one direction of the resonator is "
                                 "seen and no other. Add a recording that starts at theta_A = %1 "
                                 "degrees and lasts %2 s or longer.");
        case ReasonCode::below_noise:
            return VYBEG_MESSAGE("Reason",
                                 "The difference between the modes, %1, is less than five of its "
                                 "standard deviations, %2: it has no axis that could be told.");
        case ReasonCode::confounded_rotation:
            return VYBEG_MESSAGE("Reason",
                                 "At one angle a rotation and a damping anisotropy turn the wave "
                                 "alike. Add a recording that starts at theta_A = %1 degrees and "
                                 "lasts %2 s or longer.");
        case ReasonCode::free_model:
            return VYBEG_MESSAGE("Reason",
                                 "The free model takes the channels as any two views of the "
                                 "modes: it has no angles.");
        case ReasonCode::modes_not_apart:
            return VYBEG_MESSAGE("Reason", "The two modes cannot be told apart.");
        case ReasonCode::no_decay:
            return VYBEG_MESSAGE("Reason",
                                 "No decay is seen: 1/tau is %1 with a standard deviation of %2 "
                                 "1/s. Record longer.");
        case ReasonCode::circular_wave:
            return VYBEG_MESSAGE("Reason", "A circular wave has no angle.");
        case ReasonCode::few_angles:
            return VYBEG_MESSAGE("Reason",
                                 "The waves stand at too few angles for the drift as a function of "
                                 "the angle: it needs three starts 22.5 degrees apart or more, or "
                                 "a wave that turns.");
        case ReasonCode::kappa_still_wave:
            return VYBEG_MESSAGE("Reason",
                                 "The wave turns through %1 degrees; %2 are needed to see the gain "
                                 "ratio of the channels.");
        case ReasonCode::kappa_like_damping:
            return VYBEG_MESSAGE("Reason",
                                 "In a turning wave a gain ratio of the channels and a damping "
                                 "anisotropy look the same, and only one of them is found here.");
        case ReasonCode::kappa_not_seen:
            return VYBEG_MESSAGE("Reason",
                                 "This motion does not show the gain ratio of the channels.");
        case ReasonCode::channels_one_number:
            return VYBEG_MESSAGE(
                "Reason",
                "The motion tells one number of the channels, which is taken as "
                "their gain ratio. A wrong angle between the pick-offs, or a delay "
                "between the channels, looks like it or like an anisotropy.");
        case ReasonCode::not_asked:
            return VYBEG_MESSAGE("Reason", "Its estimate was switched off.");
        case ReasonCode::amplitude_like_drift:
            return VYBEG_MESSAGE("Reason",
                                 "Within this decay a dependence on the amplitude cannot be told "
                                 "from a drift with time.");
        case ReasonCode::residual_from_elsewhere:
            return VYBEG_MESSAGE("Reason",
                                 "The residual comes from elsewhere: this term would follow it "
                                 "without explaining it.");
        case ReasonCode::too_few_windows:
            return VYBEG_MESSAGE("Reason", "This recording has too few windows for it.");
    }
    return "";
}

std::string reason_name(ReasonCode code) {
    switch (code) {
        case ReasonCode::none: return "none";
        case ReasonCode::one_direction: return "one-direction";
        case ReasonCode::below_noise: return "below-noise";
        case ReasonCode::confounded_rotation: return "confounded-rotation";
        case ReasonCode::free_model: return "free-model";
        case ReasonCode::modes_not_apart: return "modes-not-apart";
        case ReasonCode::no_decay: return "no-decay";
        case ReasonCode::circular_wave: return "circular-wave";
        case ReasonCode::few_angles: return "few-angles";
        case ReasonCode::kappa_still_wave: return "kappa-still-wave";
        case ReasonCode::kappa_like_damping: return "kappa-like-damping";
        case ReasonCode::kappa_not_seen: return "kappa-not-seen";
        case ReasonCode::channels_one_number: return "channels-one-number";
        case ReasonCode::not_asked: return "not-asked";
        case ReasonCode::amplitude_like_drift: return "amplitude-like-drift";
        case ReasonCode::residual_from_elsewhere: return "residual-from-elsewhere";
        case ReasonCode::too_few_windows: return "too-few-windows";
    }
    return "";
}

std::string english(const Reason& reason) {
    return fill_template(message_template(reason.code), reason.args);
}

}  // namespace vybeg
