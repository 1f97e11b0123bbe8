#include "map/proof/section_image.hpp"

#include "map/intervals/arb.hpp"
#include "map/intervals/curved.hpp"
#include "map/proof/clear_flight.hpp"
#include "map/proof/scene_numbers.hpp"
#include "map/proof/shooting_in_balls.hpp"
#include "map/proof/words.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>

namespace swirl::proof {

namespace {

using intervals::between;
using intervals::Curved;
using intervals::exact_middle;
using intervals::is_positive;
using intervals::lower;
using intervals::middle;
using intervals::square;
using intervals::upper;

template <class T>
T& entry_at(BallPoint<T>& z, std::size_t index) {
    return *std::array<T*, 5>{&z.psi, &z.chi, &z.vn, &z.vt, &z.spin}[index];
}

/// v_n of a frictionless disk that leaves the wall on a level of J.
template <class S, class T>
T normal_velocity(const SceneIn<S>& scene, double jacobi, const T& psi, const T& vt) {
    const auto at = sine_cosine(psi);
    const T x = scene.beta * at.cosine + (S(1) - scene.alpha), y = scene.beta * at.sine;
    const T along = vt - x;
    return y - sqrt(x * x + y * y - along * along + S(2) * S(jacobi));
}

BallPoint<StepDual> differentiated_point(const SectionFlights& flights, const BallVector& x) {
    BallPoint<StepDual> z;
    for (std::size_t a = 0; a < x.size(); ++a)
        entry_at(z, flights.chart[a]) = StepDual::variable(x[a], flights.chart[a]);
    if (flights.jacobi) z.vn = normal_velocity(flights.scene, *flights.jacobi, z.psi, z.vt);
    return z;
}

/// The flight of the middle point: Newton's method on its gap, and where the wall is met.
struct MiddleFlight {
    double time = 0, advance = 0;
    BallStep<StepDual> step;
    bool good = false;
};

MiddleFlight middle_flight(const SectionFlights& flights, const BallPoint<StepDual>& z, const Branch& branch,
                           double time) {
    MiddleFlight flight;
    flight.time = time;
    for (int i = 0; i < 8; ++i) {
        flight.step = step_in_balls<StepDual>(flights.scene, branch, flight.advance, z,
                                              StepDual::variable(Ball(flight.time), time_index));
        const double turn = middle(flight.step.before.psi.value - z.psi.value) + flight.time;
        const double change = middle(flight.step.gap.value) / middle(flight.step.gap.by[time_index]);
        if (!std::isfinite(turn) || !std::isfinite(change) || std::abs(change) > 0.5 * flight.time + 0.01)
            return flight;
        flight.advance = std::remainder(turn, 2 * pi<double>());
        flight.time -= change;
        if (std::abs(change) < 1e-14 * (1 + flight.time)) break;
    }
    flight.good = flight.time > 0;
    return flight;
}

SectionImage open_image(std::string why) {
    SectionImage image;
    image.open = std::move(why);
    return image;
}

/// F of a piece, by numbers that keep their dependence on the K variables e.
template <std::size_t K>
class PieceFlight {
public:
    using Number = Curved<K>;

    PieceFlight(const SectionFlights& flights, const BallSet& set, const UnitPiece& piece, const Branch& branch)
        : flights_(flights),
          scene_(scene_as<Number>(flights.scene, [](const Ball& x) { return Number(x); })),
          branch_(branch) {
        branch_.slip = branch.mode == ContactMode::frictionless ? 0 : 1;
        BallVector x = set.centre;
        std::array<double, K> half{};
        for (std::size_t j = 0; j < K; ++j) {
            const Ball at = exact_middle(between(piece.low[j], piece.high[j]));
            half[j] = upper(abs(between(piece.low[j], piece.high[j]) - at));
            for (std::size_t a = 0; a < K; ++a) x[a].add_product(set.matrix[a][j], at);
        }
        for (std::size_t a = 0; a < K; ++a) {
            Number& coordinate = entry_at(z_, flights.chart[a]);
            coordinate = Number(x[a]);
            for (std::size_t j = 0; j < K; ++j)
                coordinate += Number(set.matrix[a][j]) * Number::variable(-half[j], half[j], j);
        }
        if (flights.jacobi) z_.vn = normal_velocity(scene_, *flights.jacobi, z_.psi, z_.vt);
        middle_ = differentiated_point(flights, x);
        all_ = {values_of(z_.psi), values_of(z_.chi), values_of(z_.vn), values_of(z_.vt), values_of(z_.spin)};
    }

    SectionImage image(double time) {
        const MiddleFlight flight = middle_flight(flights_, middle_, branch_, time);
        if (!flight.good) return open_image("no flight ends so from the middle of a piece");
        if (!enclose_time(flight)) return open_image("the time of a piece's flights is not enclosed");
        branch_.slip = slip(flight);
        Margins margins;
        BallStep<Number> step = step_in_balls<Number>(scene_, branch_, flight.advance, z_, tau_, &margins);
        for (const Margin& margin : margins)
            if (!is_positive(margin.value))
                return open_image(words("%s: it lies in %.3g ... %.3g", margin.name.c_str(), lower(margin.value),
                                        upper(margin.value)));
        const Clearance clearance = clear_flight(flights_.scene, all_, values_of(tau_), branch_.vertex_step, 2000);
        if (clearance.verdict != Verdict::proven) return open_image(clearance.reason);
        SectionImage image;
        for (const std::size_t index : flights_.chart) {
            const Number& to = entry_at(step.after, index);
            image.middle.push_back(Ball(to.mid) + intervals::around(0, to.rest));
            image.slopes.emplace_back();
            for (const double slope : to.by) image.slopes.back().emplace_back(slope);
            image.curves.emplace_back();
            for (const double curve : to.two) image.curves.back().emplace_back(curve);
        }
        return image;
    }

private:
    Number gap_at(const MiddleFlight& flight, const Number& tau) const {
        return step_in_balls<Number>(scene_, branch_, flight.advance, z_, tau).gap;
    }

    /// tau_ = a polynomial p(e) and a range: for every e Newton's operator p − g(z, p)/∂_τ g maps p's surroundings into
    /// themselves, with ∂_τ g over all of the piece.
    bool enclose_time(const MiddleFlight& flight) {
        const Number start(flight.time);
        const double rate = middle(flight.step.gap.by[time_index]);
        Number guess = start;
        for (int i = 0; i < 2; ++i) {
            const Number gap = gap_at(flight, guess);
            if (!is_finite(gap)) return false;
            guess = guess - Number(1 / rate) * gap;
            guess.rest = 0;  // a polynomial, whatever its coefficients
        }
        const Ball open = values_of(gap_at(flight, guess));
        const double reach = 2 * upper(abs(open)) / std::abs(rate) + 1e-18;
        if (!std::isfinite(reach)) return false;
        BallPoint<StepDual> over;
        for (std::size_t index = 0; index < 5; ++index) entry_at(over, index) = StepDual(entry_at(all_, index));
        const Ball wide = values_of(guess) + intervals::around(0, reach);
        const StepDual gap =
            step_in_balls<StepDual>(flights_.scene, branch_, flight.advance, over, StepDual::variable(wide, time_index))
                .gap;
        if (!is_positive(gap.by[time_index])) return false;
        const double change = upper(abs(open / gap.by[time_index]));
        tau_ = guess;
        tau_.rest = change;
        return change < reach && lower(values_of(tau_)) > 0;
    }

    /// The sign of the slip before the impact; 0 where it is not certain and sticking in compression allows it.
    int slip(const MiddleFlight& flight) const {
        if (branch_.mode == ContactMode::frictionless) return 0;
        const BallStep<Number> step = step_in_balls<Number>(scene_, branch_, flight.advance, z_, tau_);
        const Ball ut = values_of(kinematics(scene_, step.before).ut);
        if (is_positive(ut)) return 1;
        if (is_negative(ut)) return -1;
        return branch_.mode == ContactMode::c_sticking ? 0 : middle(ut) > 0 ? 1 : -1;
    }

    const SectionFlights& flights_;
    SceneIn<Number> scene_;
    Branch branch_;
    BallPoint<Number> z_;
    BallPoint<StepDual> middle_;
    BallPoint<Ball> all_;
    Number tau_;
};

}  // namespace

BallSet ball_set(const SectionSet& set) {
    BallSet balls;
    const std::size_t n = set.centre.size();
    for (const double x : set.centre) balls.centre.emplace_back(x);
    balls.matrix.assign(n, BallVector(n));
    balls.inverse.assign(n, BallVector(n));
    const auto size = static_cast<slong>(n);
    arb_mat_t a, inverse;
    arb_mat_init(a, size, size);
    arb_mat_init(inverse, size, size);
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = 0; j < n; ++j) {
            balls.matrix[i][j] = Ball(set.matrix[i * n + j]);
            arb_set(arb_mat_entry(a, i, j), balls.matrix[i][j].raw());
        }
    balls.invertible = arb_mat_inv(inverse, a, intervals::ball_precision) != 0;
    for (std::size_t i = 0; balls.invertible && i < n; ++i)
        for (std::size_t j = 0; j < n; ++j) arb_set(balls.inverse[i][j].raw(), arb_mat_entry(inverse, i, j));
    arb_mat_clear(a);
    arb_mat_clear(inverse);
    return balls;
}

SectionFlights::SectionFlights(const Scene<double>& of, const ChaosClaim& claim)
    : scene(ball_scene(of)), chart(section_chart(of)), jacobi(claim.jacobi) {}

SectionImage image_of(const SectionFlights& flights, const BallSet& set, const UnitPiece& piece, const Branch& branch,
                      double time) {
    switch (set.dimension()) {
        case 2:
            return PieceFlight<2>(flights, set, piece, branch).image(time);
        case 4:
            return PieceFlight<4>(flights, set, piece, branch).image(time);
        default:
            return PieceFlight<5>(flights, set, piece, branch).image(time);
    }
}

}  // namespace swirl::proof
