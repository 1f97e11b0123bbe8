#include "map/proof/cell_flight.hpp"

#include <numeric>
#include <utility>

namespace swirl::proof {

namespace {

struct Share {
    double from, to;
    std::vector<int> vertices;  ///< not known to be inside
};

/// Those of the vertices that are not proven inside throughout.
std::vector<int> open_vertices(const CellFlight<Timed>& flight, const Share& share, int arriving) {
    const auto over = flight.at(Timed::variable(share.from, share.to, 2));
    if (flight.is_far_inside(over)) return {};
    std::vector<int> open;
    for (const int k : share.vertices) {
        const auto gap = flight.gap(over, k);
        // It is on the wall at the end: inside before if it goes outwards throughout, after if inwards.
        const bool leaves = k == 0 && share.from == 0, arrives = k == arriving && share.to == 1;
        const bool inside = leaves ? is_negative(gap.rate) : arrives ? is_positive(gap.rate) : is_negative(gap.value);
        if (!inside) open.push_back(k);
    }
    return open;
}

}  // namespace

Verdict clear_over_cell(const SceneIn<Timed>& scene, const BallPoint<Timed>& z, const Timed& tau, long j,
                        const TimePieces& pieces) {
    const CellFlight<Timed> flight(scene, z, tau);
    const int sides = flight.vertices(), arriving = static_cast<int>(((j % sides) + sides) % sides);
    std::vector<int> all(static_cast<std::size_t>(sides));
    std::iota(all.begin(), all.end(), 0);
    std::vector<Share> waiting{{0, 1, std::move(all)}};
    bool doubtful = false;
    for (int looked = 0; !waiting.empty(); ++looked) {
        if (looked > pieces.most) return Verdict::undecided;
        const Share share = std::move(waiting.back());
        waiting.pop_back();
        std::vector<int> open = open_vertices(flight, share, arriving);
        if (open.empty()) continue;
        const double middle = 0.5 * (share.from + share.to);
        const auto moment = flight.at(Timed(middle));
        for (const int k : open)
            if (is_positive(flight.gap(moment, k).value)) return Verdict::refuted;
        if (share.to - share.from < pieces.shortest) {
            doubtful = true;  // another moment may yet refute it
            continue;
        }
        waiting.push_back({middle, share.to, open});
        waiting.push_back({share.from, middle, std::move(open)});
    }
    return doubtful ? Verdict::undecided : Verdict::proven;
}

}  // namespace swirl::proof
