// What a solver has to do to be compared: the next impact, from just after an impact. README.md, "The task".
#pragma once

#include "map/collision_map.hpp"

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

namespace swirl::peers {

using State = PostImpactState<double>;

/// What a peer found. Nothing but `found` is meaningful unless it is true.
struct Impact {
    bool found = false;
    double time = 0;  ///< of flight
    int vertex = 0;   ///< that struck, counted from the one before
    State after{};
};

/// What a peer may be asked for; each reads what concerns it.
struct Settings {
    double tolerance = 1e-9;  ///< relative and absolute (SUNDIALS)
    double step = 0;          ///< the longest step (SUNDIALS; 0: its own choice), the step (Box2D)
};

class Peer {
public:
    virtual ~Peer() = default;
    /// The next impact after a state.
    virtual Impact next(const State& start) = 0;
    /// A number of impacts in a row, each from the one before; `state` moves on. Returns how many were found.
    virtual int follow(State& state, int count) {
        for (int done = 0; done < count; ++done) {
            const Impact impact = next(state);
            if (!impact.found) return done;
            state = impact.after;
        }
        return count;
    }
    /// What is timed: `count` impacts in a row from the start numbered `first`; where the orbit is lost, on from the
    /// next start, as long as there is one. A peer that follows many orbits at once takes as many starts, from `first`
    /// on, and makes `count` impacts of each. Returns how many were found.
    virtual long follow_from(const std::vector<State>& starts, std::size_t first, std::size_t count) {
        long found = 0;
        for (std::size_t at = first; found < static_cast<long>(count) && at < starts.size(); ++at) {
            State state = starts[at];
            found += follow(state, static_cast<int>(static_cast<long>(count) - found));
        }
        return found;
    }
    /// Follows an orbit and keeps every impact; fewer of them where one is not found.
    virtual std::vector<Impact> row(State state, std::size_t count) {
        std::vector<Impact> impacts;
        while (impacts.size() < count) {
            impacts.push_back(next(state));
            state = impacts.back().after;
            if (!impacts.back().found) break;
        }
        return impacts;
    }
};

/// Flights longer than this are given up by the peers that integrate; those compared last some 1/ω_s.
inline constexpr double longest_flight = 100;

/// `double`, `quad`, `paper`, `brent` or `fixed-step`; `abreast` is `double`, 64 orbits at once in the lanes of
/// vectors, in one thread; `newton` and `stronge` are `double` under those laws of impact, the others have Poisson's.
/// Null for another name.
std::unique_ptr<Peer> make_swirl_peer(const std::string& name, const Scene<double>& scene);
std::unique_ptr<Peer> make_sundials_peer(const Scene<double>& scene, const Settings& settings);
std::unique_ptr<Peer> make_box2d_peer(const Scene<double>& scene, const Settings& settings);
/// Its slop, skin, scale and container, in one line.
std::string box2d_numbers(const Scene<double>& scene);

}  // namespace swirl::peers
