#include "map/proof_check/carried_piece.hpp"

#include "map/intervals/arb.hpp"
#include "map/intervals/curved.hpp"
#include "map/proof_check/check_flight.hpp"

#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <stdexcept>
#include <utility>

namespace swirl::proof_check {

namespace {

using intervals::around;
using intervals::Curved;
using intervals::lower;
using intervals::middle;
using intervals::upper;

constexpr std::size_t by_time = 5, by_next = 6;

/// The equations' values and derivatives by the unknowns: those of the next point's coordinates that are kept, and
/// time.
template <class S>
struct System {
    std::vector<S> values;
    std::vector<std::vector<S>> by_unknown;
};

/// Of z and the unknowns, these with derivatives or without.
template <class S>
StepVariablesOver<S> variables_of(const CheckedChaos& chaos, const std::array<S, 5>& z, const std::vector<S>& unknown,
                                  bool derivatives) {
    const auto number = [&](const S& value, std::size_t index) {
        return derivatives ? GradientOver<S>(value, index) : GradientOver<S>(value);
    };
    std::array<GradientOver<S>, variables> g;
    for (std::size_t i = 0; i < 5; ++i) g[i] = GradientOver<S>(z[i]);
    for (std::size_t a = 0; a < chaos.kept.size(); ++a)
        g[by_next + chaos.kept[a]] = number(unknown[a], by_next + chaos.kept[a]);
    g[by_time] = number(unknown.back(), by_time);
    return {g[0], g[1], g[2], g[3], g[4], g[5], g[6], g[7], g[8], g[9], g[10]};
}

template <class S>
System<S> system_of(const CheckedChaos& chaos, const SceneOver<S>& scene, const std::array<S, 5>& z,
                    const std::vector<S>& unknown, const StatedStep& step, bool derivatives,
                    std::vector<Inequality>* inequalities = nullptr) {
    const StepEquationsOver<S> all =
        step_equations(scene, step, variables_of(chaos, z, unknown, derivatives), inequalities);
    std::vector<const GradientOver<S>*> list{&all.position_x, &all.position_y, &all.friction, &all.restitution};
    if (!scene.disk()) list.push_back(&all.turn);
    if (chaos.kept.back() == 4) list.push_back(&all.spin);
    System<S> system;
    for (const GradientOver<S>* equation : list) {
        system.values.push_back(equation->f);
        if (!derivatives) continue;
        system.by_unknown.emplace_back();
        for (const std::size_t index : chaos.kept) system.by_unknown.back().push_back(equation->d[by_next + index]);
        system.by_unknown.back().push_back(equation->d[by_time]);
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

/// The slip before the impact.
template <class S>
S slip_before(const SceneOver<S>& scene, const StepVariablesOver<S>& at) {
    const auto turn = sine_cosine(at.psi.f - at.next_psi.f - at.tau.f);
    return turn.sine * at.vn.f + turn.cosine * at.vt.f + at.spin.f * scene.alpha * sine_cosine(at.next_chi.f).cosine -
           scene.beta * sine_cosine(at.next_psi.f).cosine;
}

/// Its sign; 0 where it is not certain and sticking in compression allows that.
int slip_of(const Ball& slip, const std::string& mode) {
    if (mode == "frictionless") return 0;
    if (is_positive(slip)) return 1;
    if (is_negative(slip)) return -1;
    return mode == "c-sticking" ? 0 : middle(slip) > 0 ? 1 : -1;
}

/// The next point and time of one point, with the inverse of the equations' derivative.
struct MiddleStep {
    Eigen::VectorXd unknown;  ///< empty: none was found
    Eigen::MatrixXd inverse;
};

MiddleStep middle_step(const CheckedChaos& chaos, const std::array<Ball, 5>& z, Eigen::VectorXd unknown,
                       StatedStep step) {
    MiddleStep found;
    for (int i = 0; i < 25; ++i) {
        const Balls at = balls_of(unknown);
        step.slip = slip_of(slip_before(chaos.scene, variables_of(chaos, z, at, false)), step.contact_mode);
        if (step.slip == 0 && step.contact_mode != "frictionless") step.slip = 1;
        const System<Ball> system = system_of(chaos, chaos.scene, z, at, step, true);
        Eigen::VectorXd values(unknown.size());
        for (Eigen::Index k = 0; k < values.size(); ++k) values[k] = middle(system.values[static_cast<std::size_t>(k)]);
        found.inverse = middles_of(system.by_unknown).inverse();
        Eigen::VectorXd change = found.inverse * values;
        if (!change.allFinite()) return {};
        const double size = change.lpNorm<Eigen::Infinity>();
        if (size > 0.5) change *= 0.5 / size;
        unknown -= change;
        if (size > 1e-14 * (1 + unknown.lpNorm<Eigen::Infinity>()) && (i < 12 || size > 1e-12)) continue;
        found.unknown = unknown;
        return found;
    }
    return {};
}

/// A piece's points, and the next ones, by numbers that depend on its K directions.
template <std::size_t K>
class PieceImage {
public:
    using Number = Curved<K>;
    using Numbers = std::vector<Number>;

    PieceImage(const CheckedChaos& chaos, const StatedSet& set, const CarriedPiece& piece)
        : chaos_(chaos), scene_{Number(chaos.scene.alpha),   Number(chaos.scene.beta),
                                Number(chaos.scene.mu),      Number(chaos.scene.restitution),
                                Number(chaos.scene.inertia), Number(chaos.scene.spacing),
                                chaos.scene.sides,           chaos.scene.law} {
        for (std::size_t a = 0; a < K; ++a) {
            Number& x = z_[chaos.chart[a]];
            x = Number(set.centre[a]);
            for (std::size_t j = 0; j < K; ++j)
                x += Number(set.matrix[a * K + j]) * Number::variable(piece.low[j], piece.high[j], j);
        }
        on_level_ = !chaos.jacobi || enclose_normal_velocity();
    }

    Carried image(const StatedCovering& covering, const Eigen::VectorXd& guess) {
        Carried result;
        result.open = "a piece's points are not shown to lie on the level of J";
        if (!on_level_) return result;
        step_.vertex_step = covering.vertex_step;
        step_.contact_mode = covering.contact_mode;
        std::array<Ball, 5> at;
        for (std::size_t i = 0; i < 5; ++i) at[i] = Ball(z_[i].mid);
        const MiddleStep start = middle_step(chaos_, at, guess, step_);
        result.open = "no next point is found from the middle of a piece";
        if (start.unknown.size() == 0) return result;
        result.found = start.unknown;
        result.open = "the next points of a piece are not enclosed";
        const bool enclosed = enclose(start);
        for (std::size_t j = 0; j < K; ++j) {
            double effect = 0;
            for (const Number& next : next_) effect += std::abs(next.by[j]);
            if (std::isfinite(effect)) result.effects.push_back(effect);
        }
        if (result.effects.size() < K) result.effects.clear();
        if (!enclosed) return result;
        result.open = what_is_open(covering.vertex_step);
        for (std::size_t a = 0; a < chaos_.kept.size(); ++a) {
            const std::size_t index = chaos_.kept[a];
            if (std::find(chaos_.chart.begin(), chaos_.chart.end(), index) == chaos_.chart.end()) continue;
            result.middle.push_back(Ball(next_[a].mid) + around(0, next_[a].rest));
            result.slopes.emplace_back();
            for (const double slope : next_[a].by) result.slopes.back().emplace_back(slope);
            result.curves.emplace_back();
            for (const double curve : next_[a].two) result.curves.back().emplace_back(curve);
        }
        return result;
    }

private:
    /// v_n of a disk without friction from energy less angular momentum, in axes along the swirl's arm: Newton's method
    /// to a polynomial, then over the intervals about it.
    bool enclose_normal_velocity() {
        const auto turn = sine_cosine(z_[0]);
        const Number reach = Number(1) - scene_.alpha, &vt = z_[3];
        const Number x = scene_.beta + reach * turn.cosine, y = reach * turn.sine;
        const auto open = [&](const Number& vn) {
            const Number vx = turn.cosine * vn - turn.sine * vt, vy = turn.sine * vn + turn.cosine * vt;
            return Number(0.5) * (vx * vx + vy * vy) - (x * vy - y * vx) - Number(*chaos_.jacobi);
        };
        const auto slope = [&](const Number& vn) { return vn - scene_.beta * turn.sine; };  // its derivative by v_n
        const double a = 1 - scene_.alpha.mid + scene_.beta.mid * std::cos(z_[0].mid),
                     b = scene_.beta.mid * std::sin(z_[0].mid), c = z_[3].mid - a;
        Number vn(b - std::sqrt(a * a + b * b - c * c + 2 * *chaos_.jacobi));
        if (!std::isfinite(vn.mid)) return false;
        const double rate = slope(vn).mid;
        for (int i = 0; i < 3; ++i) {
            vn = vn - Number(1 / rate) * open(vn);
            vn.rest = 0;
        }
        const double left = upper(abs(values_of(open(vn)))), within = 2 * left / std::abs(rate) + 1e-18;
        if (!std::isfinite(within)) return false;
        Number wide = vn;
        wide.rest = within;
        const Ball over = values_of(slope(wide));
        if (!is_negative(over)) return false;  // the branch that leaves the wall
        vn.rest = upper(Ball(left) / abs(over));
        z_[2] = vn;
        return vn.rest < within;
    }

    /// C times the equations' values at z(e) and polynomials of e.
    Numbers changes_at(const Eigen::MatrixXd& inverse, const Numbers& next) const {
        const Numbers open = system_of(chaos_, scene_, z_, next, step_, false).values;
        Numbers changes(open.size());
        for (std::size_t i = 0; i < open.size(); ++i)
            for (std::size_t l = 0; l < open.size(); ++l)
                changes[i] += Number(inverse(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(l))) * open[l];
        return changes;
    }

    /// |1 − C E_y| over all that lies within `reach` of the polynomials.
    Eigen::MatrixXd contraction(const Eigen::MatrixXd& inverse, const Eigen::VectorXd& reach) const {
        const auto m = static_cast<std::size_t>(reach.size());
        Numbers wide = next_;
        for (std::size_t i = 0; i < m; ++i) wide[i].rest = reach[static_cast<Eigen::Index>(i)];
        const auto rows = system_of(chaos_, scene_, z_, wide, step_, true).by_unknown;
        Eigen::MatrixXd result(reach.size(), reach.size());
        for (std::size_t i = 0; i < m; ++i)
            for (std::size_t j = 0; j < m; ++j) {
                Number entry(i == j ? 1 : 0);
                for (std::size_t l = 0; l < m; ++l)
                    entry += Number(-inverse(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(l))) * rows[l][j];
                result(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) = upper(abs(values_of(entry)));
            }
        return result;
    }

    /// next_ = polynomials of e with a range: Krawczyk's operator about them, −C E + (1 − C E_y) r, maps |r| ≤ reach
    /// into its inside for every e.
    bool enclose(const MiddleStep& start) {
        next_.clear();
        for (const double x : start.unknown) next_.emplace_back(x);
        step_.slip = middle_slip();
        if (step_.slip == 0 && step_.contact_mode != "frictionless") step_.slip = 1;
        for (int i = 0; i < 2; ++i) {
            const Numbers changes = changes_at(start.inverse, next_);
            for (std::size_t k = 0; k < next_.size(); ++k) {
                next_[k] = next_[k] - changes[k];
                next_[k].rest = 0;
            }
        }
        step_.slip =
            slip_of(values_of(slip_before(scene_, variables_of(chaos_, z_, next_, false))), step_.contact_mode);
        const Numbers left = changes_at(start.inverse, next_);
        Eigen::VectorXd open(start.unknown.size());
        for (Eigen::Index k = 0; k < open.size(); ++k)
            open[k] = upper(abs(values_of(left[static_cast<std::size_t>(k)])));
        Eigen::VectorXd reach = (2 * open).array() + 1e-18;
        for (int round = 0; round < 2 && reach.allFinite(); ++round) {
            const Eigen::MatrixXd rest = contraction(start.inverse, reach);
            const Eigen::VectorXd image = (open + rest * reach) * (1 + 1e-12);  // the sums are rounded
            if (!image.allFinite()) return false;
            if ((image.array() < reach.array()).all()) {
                for (std::size_t k = 0; k < next_.size(); ++k) next_[k].rest = image[static_cast<Eigen::Index>(k)];
                return true;
            }
            for (int i = 0; i < 30; ++i) reach = 1.05 * (open + rest * reach).cwiseMax(open);
        }
        return false;
    }

    int middle_slip() const {
        const Number slip = slip_before(scene_, variables_of(chaos_, z_, next_, false));
        return slip_of(Ball(slip.mid), step_.contact_mode);
    }

    /// The inequalities of the impact, and the flight; empty if all hold.
    std::string what_is_open(int vertex_step) const {
        std::vector<Inequality> inequalities;
        system_of(chaos_, scene_, z_, next_, step_, false, &inequalities);
        inequalities.push_back({"flight time > 0", values_of(next_.back())});
        char text[200];
        for (const Inequality& wanted : inequalities)
            if (!is_positive(wanted.value)) {
                std::snprintf(text, sizeof text, "%s does not hold: it is %.3g at least", wanted.name.c_str(),
                              lower(wanted.value));
                return text;
            }
        const FlightBox flight{values_of(z_[0]), values_of(z_[1]), values_of(z_[2]),
                               values_of(z_[3]), values_of(z_[4]), values_of(next_.back())};
        return open_vertex(chaos_.scene, flight, vertex_step);
    }

    const CheckedChaos& chaos_;
    SceneOver<Number> scene_;
    std::array<Number, 5> z_;
    Numbers next_;
    StatedStep step_;
    bool on_level_ = false;
};

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
    const auto size = static_cast<slong>(n);
    arb_mat_t matrix, inverse;
    arb_mat_init(matrix, size, size);
    arb_mat_init(inverse, size, size);
    for (std::size_t i = 0; i < n * n; ++i)
        arb_set_d(arb_mat_entry(matrix, static_cast<slong>(i / n), static_cast<slong>(i % n)), set.matrix[i]);
    BallRows rows;
    if (arb_mat_inv(inverse, matrix, intervals::ball_precision) != 0)
        for (slong i = 0; i < size; ++i) {
            rows.emplace_back(n);
            for (std::size_t j = 0; j < n; ++j)
                arb_set(rows.back()[j].raw(), arb_mat_entry(inverse, i, static_cast<slong>(j)));
        }
    arb_mat_clear(matrix);
    arb_mat_clear(inverse);
    return rows;
}

Carried carried(const CheckedChaos& chaos, const StatedSet& set, const StatedCovering& covering,
                const CarriedPiece& piece) {
    switch (chaos.chart.size()) {
        case 2:
            return PieceImage<2>(chaos, set, piece).image(covering, piece.guess);
        case 4:
            return PieceImage<4>(chaos, set, piece).image(covering, piece.guess);
        default:
            return PieceImage<5>(chaos, set, piece).image(covering, piece.guess);
    }
}

}  // namespace swirl::proof_check
