// The three modes of Sun 2019 (docs/references.md) and the finer kinds behind them.
#pragma once

#include "analysis/enum_name.hpp"

#include <string>
#include <string_view>

namespace swirl::analysis {

/// The modes of Sun 2019 (docs/references.md): chaotic, quasi-steady (finitely many or a closed curve of states),
/// steady (one state).
enum class Mode { steady, quasi_steady, chaotic, undecided };

/// What is known beyond that.
enum class Kind {
    none,                 ///< nothing to name: the orbit ended, or the evidence is not enough
    fixed_point,          ///< F(z) = z, isolated
    family,               ///< F(z) = z, a member of a family: a multiplier is 1
    cycle,                ///< Fᵏ(z) = z, k > 1
    quasi_periodic,       ///< a closed curve or torus, with an irrational rotation number
    landing,              ///< a cycle that comes to stand on the wall and leaves it again
    rolling,              ///< in contact for ever, at rest in the co-rotating frame (also called snaking)
    rolling_librating,    ///< in contact for ever, swinging about a direction of the co-rotating frame
    rolling_circulating,  ///< in contact for ever, turning on and on against the co-rotating frame
    sliding,              ///< in contact for ever and slipping
    two_vertex,           ///< in contact for ever on the two vertices of an edge
    chaotic,              ///< a positive largest exponent
    transient,            ///< still changing: its size, or what it does
    accelerated,          ///< its energy grows without end
    chord,                ///< on a winding no-slip chord, or on the way along it, to a limit of S
    riding                ///< off the wall for ever: it goes along with a floor that drags
};

inline std::string_view name_of(Mode mode) {
    using enum Mode;
    return name_in<Mode>(
        {{steady, "steady"}, {quasi_steady, "quasi-steady"}, {chaotic, "chaotic"}, {undecided, "undecided"}}, mode);
}

inline std::string_view name_of(Kind kind) {
    using enum Kind;
    return name_in<Kind>({{none, "none"},
                          {fixed_point, "fixed-point"},
                          {family, "family"},
                          {cycle, "cycle"},
                          {quasi_periodic, "quasi-periodic"},
                          {landing, "landing"},
                          {rolling, "rolling"},
                          {rolling_librating, "rolling-librating"},
                          {rolling_circulating, "rolling-circulating"},
                          {sliding, "sliding"},
                          {two_vertex, "two-vertex"},
                          {chaotic, "chaotic"},
                          {transient, "transient"},
                          {accelerated, "accelerated"},
                          {chord, "chord"},
                          {riding, "riding"}},
                         kind);
}

// One piece of evidence for a verdict.

/// What was measured, against what, what it says, and what other value would have changed the verdict.
struct Evidence {
    std::string name;
    double value = 0;
    double threshold = 0;
    std::string says;
    std::string changes_if;
};

/// A threshold as it stands in a sentence: three digits.
std::string in_words(double number);

}  // namespace swirl::analysis
