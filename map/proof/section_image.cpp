#include "map/proof/section_image.hpp"

#include "map/intervals/arb.hpp"
#include "map/proof/clear_flight.hpp"
#include "map/proof/shooting_in_balls.hpp"
#include "map/proof/words.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

namespace swirl::proof {

namespace {

using intervals::between;
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
template <class T>
T normal_velocity(const BallScene& scene, double jacobi, const T& psi, const T& vt) {
    const auto at = sine_cosine(psi);
    const T x = scene.beta * at.cosine + (Ball(1) - scene.alpha), y = scene.beta * at.sine;
    const T along = vt - x;
    return y - sqrt(x * x + y * y - along * along + Ball(2) * Ball(jacobi));
}

BallPoint<StepDual> differentiated_point(const SectionFlights& flights, const BallVector& x) {
    BallPoint<StepDual> z;
    for (std::size_t a = 0; a < x.size(); ++a)
        entry_at(z, flights.chart[a]) = StepDual::variable(x[a], flights.chart[a]);
    if (flights.jacobi) z.vn = normal_velocity(flights.scene, *flights.jacobi, z.psi, z.vt);
    return z;
}

BallPoint<Ball> values_of_point(const BallPoint<StepDual>& z) {
    return {z.psi.value, z.chi.value, z.vn.value, z.vt.value, z.spin.value};
}

/// Σ_a by_a (A q)_a for the chart's coordinates.
Ball along_set(const SectionFlights& flights, const StepDual& f, const BallSet& set, const BallVector& q) {
    Ball sum;
    for (std::size_t j = 0; j < q.size(); ++j) {
        Ball slope;
        for (std::size_t a = 0; a < q.size(); ++a) slope.add_product(f.by[flights.chart[a]], set.matrix[a][j]);
        sum.add_product(slope, q[j]);
    }
    return sum;
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

/// Does slip of one sign go before the impact for certain? Else, where sticking in compression allows it, 0.
int slip_of(const SectionFlights& flights, const BallStep<StepDual>& step, const Branch& branch) {
    if (branch.mode == ContactMode::frictionless) return 0;
    const Ball ut = kinematics(flights.scene, BallPoint<Ball>(values_of_point(step.before))).ut;
    if (is_positive(ut)) return 1;
    if (is_negative(ut)) return -1;
    return branch.mode == ContactMode::c_sticking ? 0 : middle(ut) > 0 ? 1 : -1;
}

/// The time of every point of a piece, by Newton's method over intervals; `open`: it is not enclosed.
struct PieceTime {
    Ball all, middle;
    bool open = true;
};

PieceTime piece_time(const SectionFlights& flights, const BallSet& set, const BallPoint<StepDual>& z,
                     const BallPoint<StepDual>& over, const BallVector& offset, const Branch& branch,
                     const MiddleFlight& flight) {
    const StepDual& gap = flight.step.gap;
    double reach = 1e-13 * (1 + flight.time) + 1e-20;
    for (std::size_t j = 0; j < offset.size(); ++j) {
        Ball slope;
        for (std::size_t a = 0; a < offset.size(); ++a) slope.add_product(gap.by[flights.chart[a]], set.matrix[a][j]);
        reach += std::abs(middle(slope) / middle(gap.by[time_index])) * upper(offset[j]);
    }
    const Ball start(flight.time);
    const Ball gap_there = step_in_balls<Ball>(flights.scene, branch, flight.advance, values_of_point(z), start).gap;
    PieceTime time;
    for (double factor = 1.25; time.open && factor < 4; factor *= 1.6) {
        const Ball wide = start + intervals::around(0, factor * reach);
        const StepDual over_all =
            step_in_balls<StepDual>(flights.scene, branch, flight.advance, over, StepDual::variable(wide, time_index))
                .gap;
        const Ball& rate = over_all.by[time_index];
        if (!is_positive(rate)) break;
        time.all = start - (gap_there + along_set(flights, over_all, set, offset)) / rate;
        time.middle = start - gap_there / rate;
        time.open = !intervals::contains_interior(wide, time.all);
    }
    return time;
}

/// dF/dq from the step's derivatives, the time by the implicit function theorem.
BallMatrix slopes_of(const SectionFlights& flights, const BallSet& set, BallStep<StepDual>& step) {
    const std::size_t n = set.dimension();
    BallMatrix slopes(n, BallVector(n));
    for (std::size_t i = 0; i < n; ++i) {
        const StepDual& f = entry_at(step.after, flights.chart[i]);
        for (std::size_t a = 0; a < n; ++a) {
            const std::size_t c = flights.chart[a];
            const Ball by_state = f.by[c] - f.by[time_index] * step.gap.by[c] / step.gap.by[time_index];
            for (std::size_t j = 0; j < n; ++j) slopes[i][j].add_product(by_state, set.matrix[a][j]);
        }
    }
    return slopes;
}

SectionImage open_image(std::string why) {
    SectionImage image;
    image.open = std::move(why);
    return image;
}

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
    const std::size_t n = set.dimension();
    const BallScene& scene = flights.scene;
    SectionImage image;
    BallVector x = set.centre;
    for (std::size_t j = 0; j < n; ++j) {
        const Ball from_to = between(piece.low[j], piece.high[j]), at = exact_middle(from_to);
        image.offset.push_back(from_to - at);
        for (std::size_t a = 0; a < n; ++a) x[a].add_product(set.matrix[a][j], at);
    }
    BallVector all = x;
    for (std::size_t a = 0; a < n; ++a)
        for (std::size_t j = 0; j < n; ++j) all[a].add_product(set.matrix[a][j], image.offset[j]);
    Branch with_slip = branch;
    with_slip.slip = branch.mode == ContactMode::frictionless ? 0 : 1;
    const BallPoint<StepDual> z = differentiated_point(flights, x), over = differentiated_point(flights, all);
    const MiddleFlight flight = middle_flight(flights, z, with_slip, time);
    if (!flight.good) return open_image("no flight ends so from the middle of a piece");
    const PieceTime tau = piece_time(flights, set, z, over, image.offset, with_slip, flight);
    if (tau.open) return open_image("the time of a piece's flights is not enclosed");

    const StepDual all_times = StepDual::variable(tau.all, time_index);
    BallStep<StepDual> step = step_in_balls<StepDual>(scene, with_slip, flight.advance, over, all_times);
    with_slip.slip = slip_of(flights, step, branch);
    step = step_in_balls<StepDual>(scene, with_slip, flight.advance, over, all_times);
    Margins margins;
    const BallPoint<Ball> from = values_of_point(over);
    step_in_balls<Ball>(scene, with_slip, flight.advance, from, tau.all, &margins);
    for (const Margin& margin : margins)
        if (!is_positive(margin.value))
            return open_image(
                words("%s: it lies in %.3g ... %.3g", margin.name.c_str(), lower(margin.value), upper(margin.value)));
    const Clearance clearance = clear_flight(scene, from, tau.all, branch.vertex_step, 2000);
    if (clearance.verdict != Verdict::proven) return open_image(clearance.reason);

    BallPoint<Ball> end = step_in_balls<Ball>(scene, with_slip, flight.advance, values_of_point(z), tau.middle).after;
    for (const std::size_t index : flights.chart) image.of_middle.push_back(entry_at(end, index));
    image.derivative = slopes_of(flights, set, step);
    return image;
}

}  // namespace swirl::proof
