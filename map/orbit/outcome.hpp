// How an orbit of the collision map ends. An ending is a value with a name, never an exception, a NaN or a hang.
#pragma once

#include <cstddef>
#include <string_view>

namespace swirl {

enum class Outcome {
    completed,    ///< everything that was asked for
    no_contact,   ///< the body never meets the wall (again): proven
    in_contact,   ///< the body stays in contact: no impact for the time `contact_horizon`
    contact_cut,  ///< in contact when it was given up, before `contact_horizon`: a motion of more than 10⁵ steps
    resting,      ///< e = 1, a disk or no friction: starts on the wall without normal velocity and is held there;
                  ///< β = 0: the motion has decayed to rest
    diverged,  ///< faster than 1e75 (Newton's law with friction can create energy at every impact), or the next impact
               ///< would be no number (`is_out_of_range`)
    unresolved,  ///< a flight outlasted the step limit of the search, or no contact motion was consistent
    riding,      ///< a dish whose floor drags or has dry friction: the body goes along with it and never meets the
                 ///< wall again (proven)
    contact_with_drag,  ///< of records up to November 2026 alone: contact over a floor that drags began
    contact_of_corner,  ///< a rounded corner came to stay on the wall, on which it would roll or slide: not followed
    contact_over_dry_floor  ///< of such records alone: a polygon came to stay on the wall over dry friction
};

/// True if the body was on the wall at the end.
inline bool ends_in_contact(Outcome outcome) {
    return outcome == Outcome::in_contact || outcome == Outcome::contact_cut;
}

inline std::string_view name_of(Outcome outcome) {
    static constexpr std::string_view names[] = {"completed",
                                                 "no-contact",
                                                 "in-contact",
                                                 "contact-cut-short",
                                                 "resting",
                                                 "diverged",
                                                 "unresolved",
                                                 "riding",
                                                 "contact-with-drag",
                                                 "contact-of-corner",
                                                 "contact-over-dry-floor"};
    return names[static_cast<std::size_t>(outcome)];
}

}  // namespace swirl
