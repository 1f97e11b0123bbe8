// The letters of an orbit's word: which smooth branch of the return map each step took.
#pragma once

#include "map/orbit/return_map.hpp"

#include <cstdint>

namespace swirl::studies {

struct Letter {
    int vertex_step = 0;
    ContactMode mode = ContactMode::frictionless;
    bool through_contact = false;  ///< the way led through sustained contact
};

/// As analyses carry it, one number: 6 · vertex step + contact mode; −1 less that where the way led through contact.
inline std::int64_t number_of(const Letter& letter) {
    constexpr int modes = 6;
    const std::int64_t number = modes * std::int64_t{letter.vertex_step} + static_cast<int>(letter.mode);
    return letter.through_contact ? -1 - number : number;
}

inline Letter letter_from(std::int64_t number) {
    constexpr int modes = 6;
    const bool through_contact = number < 0;
    if (through_contact) number = -1 - number;
    return {static_cast<int>(number / modes), static_cast<ContactMode>(number % modes), through_contact};
}

inline Letter letter_of(const ReturnStep<double>& step) {
    return {step.collision.vertex_step, step.collision.impulse.mode, !step.contacts.empty()};
}

}  // namespace swirl::studies
