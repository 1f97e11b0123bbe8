#include "map/proof_check/carried_piece.hpp"

#include "map/intervals/arb.hpp"
#include "map/proof_check/check_flight.hpp"

#include <Eigen/LU>

#include <array>
#include <cmath>
#include <cstdio>
#include <stdexcept>
#include <utility>

namespace swirl::proof_check {

namespace {

using intervals::around;
using intervals::between;
using intervals::exact_middle;
using intervals::lower;
using intervals::middle;
using intervals::radius;
using intervals::upper;

constexpr std::size_t by_time = 5, by_next = 6;

/// Energy less angular momentum of a disk without its spin, from the swirl's centre in axes along the swirl's arm.
Gradient level_of(const StatedScene& scene, const Ball& psi, const Ball& vn, const Ball& vt) {
    const Gradient angle(psi, 0), n(vn, 2), t(vt, 3);
    const Gradient c = cosine(angle), s = sine(angle);
    const Ball reach = Ball(1) - scene.alpha;
    const Gradient x = scene.beta + reach * c, y = reach * s;
    const Gradient vx = c * n - s * t, vy = s * n + c * t;
    return Ball(0.5) * (vx * vx + vy * vy) - (x * vy - y * vx);
}

/// ψ, χ, v_n, v_t, S of all points of a piece, and their derivatives by q.
struct States {
    std::array<Ball, 5> z;
    std::array<Balls, 5> by;
    bool good = true;
};

/// v_n with J = level: Newton's method over intervals on the level's equation.
void add_normal_velocity(const CheckedChaos& chaos, States& states) {
    const Ball level(*chaos.jacobi);
    const double psi = middle(states.z[0]), vt = middle(states.z[3]);
    const double a = 1 - middle(chaos.scene.alpha), b = middle(chaos.scene.beta);
    const double x = a + b * std::cos(psi), y = b * std::sin(psi);
    double vn = y - std::sqrt(x * x + y * y - (vt - x) * (vt - x) + 2 * *chaos.jacobi);
    states.good = false;
    if (!std::isfinite(vn)) return;
    double wide = 1e-14;
    for (int i = 0; i < 8 && !states.good; ++i) {
        const Ball all = around(vn, wide), start(vn);
        const Ball open = level_of(chaos.scene, states.z[0], start, states.z[3]).f - level;
        const Gradient over = level_of(chaos.scene, states.z[0], all, states.z[3]);
        if (!is_negative(over.d[2])) return;  // the branch that leaves the wall
        const Ball found = start - open / over.d[2];
        states.good = intervals::contains_interior(all, found);
        if (states.good) {
            const Gradient closer = level_of(chaos.scene, states.z[0], found, states.z[3]);
            states.z[2] = found;
            for (std::size_t j = 0; j < states.by[0].size(); ++j)
                states.by[2][j] = -(closer.d[0] * states.by[0][j] + closer.d[3] * states.by[3][j]) / closer.d[2];
            states.good = is_negative(closer.d[2]);
        }
        wide = 2 * (radius(found) + std::abs(middle(found) - vn)) + 1e-15;
    }
}

States states_of(const CheckedChaos& chaos, const StatedSet& set, const Balls& q) {
    const std::size_t n = chaos.chart.size();
    States states;
    states.by.fill(Balls(n));
    for (std::size_t a = 0; a < n; ++a) {
        Ball& x = states.z[chaos.chart[a]];
        x = Ball(set.centre[a]);
        for (std::size_t j = 0; j < n; ++j) {
            const Ball entry(set.matrix[a * n + j]);
            x.add_product(entry, q[j]);
            states.by[chaos.chart[a]][j] = entry;
        }
    }
    if (chaos.jacobi) add_normal_velocity(chaos, states);
    return states;
}

/// The equations' values and derivatives by the unknowns (next point, time) and by q.
struct System {
    Balls values;
    BallRows by_unknown, by_q;
};

StepVariables variables_of(const CheckedChaos& chaos, const States& states, const Balls& unknown) {
    std::array<Gradient, variables> g;
    for (std::size_t i = 0; i < 5; ++i) {
        g[i] = Gradient(states.z[i], i);
        g[by_next + i] = Gradient(Ball(0), by_next + i);
    }
    for (std::size_t a = 0; a < chaos.kept.size(); ++a) g[by_next + chaos.kept[a]].f = unknown[a];
    g[by_time] = Gradient(unknown.back(), by_time);
    return {g[0], g[1], g[2], g[3], g[4], g[5], g[6], g[7], g[8], g[9], g[10]};
}

System system_of(const CheckedChaos& chaos, const States& states, const Balls& unknown, const StatedStep& step,
                 std::vector<Inequality>* inequalities) {
    const StepEquations all = step_equations(chaos.scene, step, variables_of(chaos, states, unknown), inequalities);
    std::vector<const Gradient*> list{&all.position_x, &all.position_y, &all.friction, &all.restitution};
    if (!chaos.scene.disk()) list.push_back(&all.turn);
    if (chaos.kept.back() == 4) list.push_back(&all.spin);
    System system;
    const std::size_t n = chaos.chart.size();
    for (const Gradient* equation : list) {
        Balls unknowns, by_q(n);
        for (const std::size_t index : chaos.kept) unknowns.push_back(equation->d[by_next + index]);
        unknowns.push_back(equation->d[by_time]);
        for (std::size_t j = 0; j < n; ++j)
            for (std::size_t i = 0; i < 5; ++i)
                if (!is_exact_zero(equation->d[i])) by_q[j].add_product(equation->d[i], states.by[i][j]);
        system.values.push_back(equation->f);
        system.by_unknown.push_back(std::move(unknowns));
        system.by_q.push_back(std::move(by_q));
    }
    return system;
}

Eigen::MatrixXd middles_of(const BallRows& rows) {
    Eigen::MatrixXd matrix(rows.size(), rows.front().size());
    for (std::size_t i = 0; i < rows.size(); ++i)
        for (std::size_t j = 0; j < rows[i].size(); ++j) matrix(i, j) = middle(rows[i][j]);
    return matrix;
}

Balls balls_of(const Eigen::VectorXd& x) {
    Balls balls;
    for (const double entry : x) balls.emplace_back(entry);
    return balls;
}

/// The sign of the slip before the impact; 0 where it is not certain and sticking in compression allows that.
int slip_of(const CheckedChaos& chaos, const States& states, const Balls& unknown, const std::string& mode) {
    if (mode == "frictionless") return 0;
    const StepVariables at = variables_of(chaos, states, unknown);
    const auto turn = intervals::sine_cosine(at.psi.f - at.next_psi.f - at.tau.f);
    const Ball slip = turn.sine * at.vn.f + turn.cosine * at.vt.f +
                      at.spin.f * chaos.scene.alpha * intervals::sine_cosine(at.next_chi.f).cosine -
                      chaos.scene.beta * intervals::sine_cosine(at.next_psi.f).cosine;
    if (is_positive(slip)) return 1;
    if (is_negative(slip)) return -1;
    return mode == "c-sticking" ? 0 : middle(slip) > 0 ? 1 : -1;
}

/// K = m − C (E(m) + E_q dq) + (1 − C E_y)(box − m); true if it lies inside the box.
bool maps_inside(const System& at, const System& over, const Eigen::MatrixXd& inverse, const Balls& start,
                 const Balls& box, const Balls& offset, Balls& image) {
    const std::size_t m = start.size();
    image.clear();
    bool inside = true;
    for (std::size_t i = 0; i < m; ++i) {
        Ball entry = start[i];
        Balls rest(m);
        rest[i] = Ball(1);
        for (std::size_t l = 0; l < m; ++l) {
            const Ball weight(-inverse(i, l));
            entry.add_product(weight, at.values[l]);
            for (std::size_t j = 0; j < m; ++j) rest[j].add_product(weight, over.by_unknown[l][j]);
        }
        for (std::size_t j = 0; j < m; ++j) entry.add_product(rest[j], box[j] - start[j]);
        for (std::size_t j = 0; j < offset.size(); ++j) {  // summed before it is multiplied: terms cancel
            Ball slope;
            for (std::size_t l = 0; l < m; ++l) slope.add_product(Ball(-inverse(i, l)), over.by_q[l][j]);
            entry.add_product(slope, offset[j]);
        }
        inside = inside && intervals::contains_interior(box[i], entry);
        image.push_back(std::move(entry));
    }
    return inside;
}

/// −E_y⁻¹ E_q; empty where it is not known to exist.
BallRows implicit_slopes(const System& system) {
    const auto m = static_cast<slong>(system.values.size()), n = static_cast<slong>(system.by_q.front().size());
    arb_mat_t left, right, solution;
    arb_mat_init(left, m, m);
    arb_mat_init(right, m, n);
    arb_mat_init(solution, m, n);
    for (slong i = 0; i < m; ++i) {
        const auto row = static_cast<std::size_t>(i);
        for (slong j = 0; j < m; ++j)
            arb_set(arb_mat_entry(left, i, j), system.by_unknown[row][static_cast<std::size_t>(j)].raw());
        for (slong j = 0; j < n; ++j)
            arb_neg(arb_mat_entry(right, i, j), system.by_q[row][static_cast<std::size_t>(j)].raw());
    }
    BallRows slopes;
    if (arb_mat_solve(solution, left, right, intervals::ball_precision) != 0)
        for (slong i = 0; i < m; ++i) {
            slopes.emplace_back(static_cast<std::size_t>(n));
            for (slong j = 0; j < n; ++j)
                arb_set(slopes.back()[static_cast<std::size_t>(j)].raw(), arb_mat_entry(solution, i, j));
        }
    arb_mat_clear(left);
    arb_mat_clear(right);
    arb_mat_clear(solution);
    return slopes;
}

/// Newton's method at the middle; empty where it does not end.
Eigen::VectorXd solved(const CheckedChaos& chaos, const States& states, Eigen::VectorXd unknown, StatedStep& step) {
    for (int i = 0; i < 25; ++i) {
        const Balls at = balls_of(unknown);
        step.slip = slip_of(chaos, states, at, step.contact_mode);
        if (step.slip == 0 && step.contact_mode != "frictionless") step.slip = 1;
        const System system = system_of(chaos, states, at, step, nullptr);
        Eigen::VectorXd values(unknown.size());
        for (Eigen::Index k = 0; k < values.size(); ++k) values[k] = middle(system.values[static_cast<std::size_t>(k)]);
        Eigen::VectorXd change = middles_of(system.by_unknown).partialPivLu().solve(values);
        if (!change.allFinite()) return {};
        const double size = change.lpNorm<Eigen::Infinity>();
        if (size > 0.5) change *= 0.5 / size;
        unknown -= change;
        if (size < 1e-14 * (1 + unknown.lpNorm<Eigen::Infinity>())) return unknown;
        if (i >= 12 && size < 1e-12) return unknown;
    }
    return {};
}

}  // namespace

CheckedChaos checked_chaos(const StatedChaos& chaos) {
    CheckedChaos checked;
    checked.scene = scene_of(chaos.scene);
    const bool disk = chaos.scene.sides == 0, smooth = chaos.scene.mu == 0;
    if (smooth && !(disk && chaos.scene.restitution == 1))
        throw std::invalid_argument("without friction only a disk at restitution 1 is looked at");
    checked.chart = !disk    ? std::vector<std::size_t>{0, 1, 2, 3, 4}
                    : smooth ? std::vector<std::size_t>{0, 3}
                             : std::vector<std::size_t>{0, 2, 3, 4};
    checked.kept = smooth ? std::vector<std::size_t>{0, 2, 3} : checked.chart;
    checked.jacobi = chaos.jacobi;
    if (smooth != chaos.jacobi.has_value())
        throw std::invalid_argument("a level of J goes with a disk without friction, and with no other");
    const std::size_t n = checked.chart.size();
    for (const StatedSet& set : chaos.sets)
        if (set.centre.size() != n || set.matrix.size() != n * n)
            throw std::invalid_argument("a set has another number of coordinates than its scene");
    return checked;
}

BallRows inverse_of(const StatedSet& set) {
    const std::size_t n = set.centre.size();
    System identity;  // A x = 1 as the linearised system −A⁻¹ (−1)
    identity.values = Balls(n);
    identity.by_unknown.assign(n, Balls(n));
    identity.by_q.assign(n, Balls(n));
    for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t j = 0; j < n; ++j) identity.by_unknown[i][j] = Ball(set.matrix[i * n + j]);
        identity.by_q[i][i] = Ball(-1);
    }
    return implicit_slopes(identity);
}

namespace {

/// The next points and times of a piece, enclosed: of its middle alone, and of all.
struct NextPoints {
    Balls of_middle, all;
    StatedStep step;  ///< with the slip
    bool good = false;
};

NextPoints next_points(const CheckedChaos& chaos, const States& centre, const States& all, const Balls& offset,
                       const Eigen::VectorXd& found, const StatedCovering& covering, StatedStep step) {
    NextPoints next_ones;
    const std::size_t n = offset.size();
    const Balls start = balls_of(found);
    const System rough = system_of(chaos, centre, start, step, nullptr);
    const Eigen::MatrixXd inverse = middles_of(rough.by_unknown).inverse();
    if (!inverse.allFinite()) return next_ones;
    Balls narrow, wide;
    const Eigen::MatrixXd slopes = (inverse * middles_of(rough.by_q)).cwiseAbs();
    for (std::size_t i = 0; i < start.size(); ++i) {
        double reach = 1e-11;
        narrow.push_back(start[i] + around(0, reach));
        for (std::size_t j = 0; j < n; ++j)
            reach += slopes(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) * upper(offset[j]);
        wide.push_back(start[i] + around(0, 1.6 * reach));
    }
    step.slip = slip_of(chaos, all, wide, covering.contact_mode);
    const System at_middle = system_of(chaos, centre, start, step, nullptr);
    next_ones.good =
        maps_inside(at_middle, system_of(chaos, centre, narrow, step, nullptr), inverse, start, narrow, Balls(n),
                    next_ones.of_middle) &&
        maps_inside(at_middle, system_of(chaos, all, wide, step, nullptr), inverse, start, wide, offset, next_ones.all);
    next_ones.step = step;
    return next_ones;
}

/// The inequalities of the impact, and the flight.
std::string check_piece(const CheckedChaos& chaos, const States& all, const NextPoints& to,
                        const StatedCovering& covering, BallRows& by_q) {
    std::vector<Inequality> inequalities;
    by_q = implicit_slopes(system_of(chaos, all, to.all, to.step, &inequalities));
    char text[200];
    for (const Inequality& wanted : inequalities)
        if (!is_positive(wanted.value)) {
            std::snprintf(text, sizeof text, "%s does not hold: it is %.3g at least", wanted.name.c_str(),
                          lower(wanted.value));
            return text;
        }
    if (by_q.empty()) return "the next points of a piece have no bounded derivative";
    const FlightBox flight{all.z[0], all.z[1], all.z[2], all.z[3], all.z[4], to.all.back()};
    return open_vertex(chaos.scene, flight, covering.vertex_step);
}

}  // namespace

Carried carried(const CheckedChaos& chaos, const StatedSet& set, const StatedCovering& covering,
                const CarriedPiece& piece) {
    Carried result;
    Balls from_to, at;
    for (std::size_t j = 0; j < chaos.chart.size(); ++j) {
        from_to.push_back(between(piece.low[j], piece.high[j]));
        at.push_back(exact_middle(from_to.back()));
        result.offset.push_back(from_to.back() - at.back());
    }
    const States centre = states_of(chaos, set, at), all = states_of(chaos, set, from_to);
    result.open = "a piece's points are not shown to lie on the level of J";
    if (!centre.good || !all.good) return result;
    StatedStep step;
    step.vertex_step = covering.vertex_step;
    step.contact_mode = covering.contact_mode;
    result.middle = solved(chaos, centre, piece.guess, step);
    result.open = "no next point is found from the middle of a piece";
    if (result.middle.size() == 0) return result;
    const NextPoints to = next_points(chaos, centre, all, result.offset, result.middle, covering, step);
    result.open = "the next points of a piece are not enclosed";
    if (!to.good) return result;
    BallRows by_q;
    result.open = check_piece(chaos, all, to, covering, by_q);
    if (!result.open.empty()) return result;
    for (const std::size_t index : chaos.chart)
        for (std::size_t a = 0; a < chaos.kept.size(); ++a)
            if (chaos.kept[a] == index) {
                result.of_middle.push_back(to.of_middle[a]);
                result.slopes.push_back(by_q[a]);
            }
    return result;
}

}  // namespace swirl::proof_check
