#include "map/proof_check/cell_motion.hpp"

#include <cstddef>
#include <utility>

namespace swirl::proof_check {

FlightSight sight_of_flight(const SceneOver<Timed>& scene, const MotionStart<Timed>& z, const Timed& tau, long j,
                            double shortest, int most) {
    const CellMotion<Timed> motion(scene, z, tau);
    const int count = scene.disk() ? 1 : scene.sides;
    const auto sides = static_cast<std::size_t>(count);
    const auto arriving = static_cast<std::size_t>(((j % count) + count) % count);
    bool clear = true;
    std::vector<std::pair<double, double>> waiting{{0.5, 1}, {0, 0.5}};
    for (int looked = 0; !waiting.empty(); ++looked) {
        if (looked > most) return FlightSight::unclear;
        const auto [from, to] = waiting.back();
        waiting.pop_back();
        const auto places = motion.at(Timed::variable(from, to, 2));
        bool open = false;
        for (std::size_t k = 0; k < sides; ++k) {
            // At a contact the gap is 0: it falls from there, or rises to it.
            if (k == 0 && from == 0)
                open = open || !is_negative(places[k].rises());
            else if (k == arriving && to == 1)
                open = open || !is_positive(places[k].rises());
            else
                open = open || !is_negative(places[k].beyond());
        }
        if (!open) continue;
        const double middle = 0.5 * (from + to);
        for (const auto& place : motion.at(Timed(middle)))
            if (is_positive(place.beyond())) return FlightSight::outside;
        if (to - from < shortest) {
            clear = false;
            continue;
        }
        waiting.emplace_back(middle, to);
        waiting.emplace_back(from, middle);
    }
    return clear ? FlightSight::clear : FlightSight::unclear;
}

}  // namespace swirl::proof_check
