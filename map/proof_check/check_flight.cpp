#include "map/proof_check/check_flight.hpp"

#include <cstdio>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

namespace swirl::proof_check {

namespace {

using intervals::between;
using intervals::sine_cosine;
using intervals::square;

/// A vertex from the container's centre, in axes fixed at the start whose direction 0 is the swirl's arm then.
struct Place {
    Ball x, y, rate_x, rate_y;
};

struct Motion {
    const StatedScene& scene;
    const FlightBox& box;
    Ball start_x, start_y, speed_x, speed_y;  ///< of the body's centre, from the swirl's

    Motion(const StatedScene& s, const FlightBox& b) : scene(s), box(b) {
        const auto n = sine_cosine(b.psi), r = sine_cosine(b.psi + b.chi);
        start_x = s.beta + n.cosine - s.alpha * r.cosine;
        start_y = n.sine - s.alpha * r.sine;
        speed_x = n.cosine * b.vn - n.sine * b.vt;
        speed_y = n.sine * b.vn + n.cosine * b.vt;
    }
    Place centre(const Ball& t) const {
        const auto arm = sine_cosine(t);
        return {start_x + speed_x * t - scene.beta * arm.cosine, start_y + speed_y * t - scene.beta * arm.sine,
                speed_x + scene.beta * arm.sine, speed_y - scene.beta * arm.cosine};
    }
    Place vertex(Place at, const Ball& t, int k) const {
        if (scene.disk()) return at;
        const auto arm = sine_cosine(box.psi + box.chi + box.spin * t + scene.spacing * Ball(k));
        at.x += scene.alpha * arm.cosine;
        at.y += scene.alpha * arm.sine;
        at.rate_x -= scene.alpha * box.spin * arm.sine;
        at.rate_y += scene.alpha * box.spin * arm.cosine;
        return at;
    }
};

/// Half the rate at which the squared distance grows.
Ball rate(const Place& at) {
    return at.x * at.rate_x + at.y * at.rate_y;
}

struct Piece {
    double from, to;
    std::vector<int> vertices;
};

}  // namespace

std::string open_vertex(const StatedScene& scene, const FlightBox& box, int arriving) {
    constexpr long long most = 50'000'000;  // vertices looked at
    const Motion motion(scene, box);
    const Ball reach2 = scene.disk() ? square(Ball(1) - scene.alpha) : Ball(1);
    const Ball ring2 = square(Ball(1) - scene.alpha);
    const double end = intervals::upper(box.tau), last = intervals::lower(box.tau);
    if (!(last > 0)) return "a flight's time is not positive";
    std::vector<int> all(scene.disk() ? 1 : static_cast<std::size_t>(scene.sides));
    std::iota(all.begin(), all.end(), 0);
    std::vector<Piece> pieces{{0, end, all}};
    long long looked = 0;
    while (!pieces.empty()) {
        Piece piece = std::move(pieces.back());
        pieces.pop_back();
        const double middle = 0.5 * (piece.from + piece.to);
        const Ball t = between(piece.from, piece.to), mid(middle), away = t - mid;
        const Place over = motion.centre(t), at = motion.centre(mid);
        const Ball x = at.x + over.rate_x * away, y = at.y + over.rate_y * away;
        if (!scene.disk() && is_negative(square(x) + square(y) - ring2)) continue;
        std::vector<int> open;
        for (const int k : piece.vertices) {
            const Place wide = motion.vertex(over, t, k), narrow = motion.vertex(at, mid, k);
            const Ball rises = rate(wide);
            const Ball gap = square(narrow.x) + square(narrow.y) - reach2 + Ball(2) * rises * away;
            const bool leaves = k == 0 && piece.from == 0 && is_negative(rises);
            const bool arrives = k == arriving && piece.to >= last && is_positive(rises);
            if (!leaves && !arrives && !is_negative(gap)) open.push_back(k);
        }
        looked += static_cast<long long>(piece.vertices.size());
        if (open.empty()) continue;
        if (looked > most || piece.to - piece.from < 1e-12 * end) {
            char text[160];
            std::snprintf(text, sizeof text, "vertex %d is not shown to be inside between t = %.9g and %.9g",
                          open.front(), piece.from, piece.to);
            return text;
        }
        pieces.push_back({middle, piece.to, open});
        pieces.push_back({piece.from, middle, std::move(open)});
    }
    return {};
}

}  // namespace swirl::proof_check
