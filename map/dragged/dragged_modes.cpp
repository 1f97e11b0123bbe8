#include "map/dragged/dragged_modes.hpp"

#include "map/dragged/dragged_derivative.hpp"
#include "map/dragged/dragged_map.hpp"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <memory>
#include <optional>
#include <stdexcept>
#include <type_traits>
#include <utility>
#include <vector>

namespace swirl {

namespace {

using Number = std::complex<double>;
using Unknowns = Eigen::Vector3d;  // τ, ψ, χ

constexpr double step_of_time = 0.04;
constexpr int points_of_psi = 160;
constexpr double most_points = 6e7;
constexpr double none = std::numeric_limits<double>::quiet_NaN();

/// What the law of impact leaves of the impulse that a mode needs; NaN where the body does not approach.
struct Deficit {
    double normal = none, tangential = none;
};

template <ImpactRule rule>
class Equations {
public:
    explicit Equations(const Scene<double>& scene)
        : scene_(scene), body_(make_body(validated(scene))), floor_(floor_drag(scene)) {}

    const Body<double>& body() const { return body_; }
    bool is_disk() const { return scene_.is_disk(); }
    double spacing() const { return is_disk() ? 0 : 2 * pi<double>() / scene_.sides; }
    double length(double tau) const { return decayed_time(floor_.drag, tau); }
    double spin_length(double tau) const { return decayed_time(floor_.spin_drag, tau); }

    /// k.
    Number response(double tau) const {
        return (cis(tau) - 1.0) * (1.0 - std::exp(-floor_.drag * tau) * cis(-tau)) / length(tau);
    }
    Number place_without_arm(double psi) const { return 1.0 + number(floor_.response) * scene_.beta * cis(-psi); }
    /// What the spin's equation has on its right side.
    double turning(double tau, long long j, const Number& k) const {
        return body_.alpha * k.imag() +
               body_.inertia / body_.alpha * floor_.spin_drag * (tau - spacing() * static_cast<double>(j));
    }

    /// The state just after the impact; its velocities by what a flight of τ to the same state wants.
    SectionPoint<double> point(const Unknowns& x, long long j) const {
        const Flying flying = flight(x);
        return {x[1], is_disk() ? 0 : x[2], flying.after.real(), flying.after.imag(), spin(x, j, flying.impulse)};
    }

    Deficit deficit(const Unknowns& x, long long j) const {
        const Flying flying = flight(x);
        const double after = spin(x, j, flying.impulse);
        const Number before = flying.after - flying.impulse;
        const PostImpactState<double> state{vec(cis(x[1])), vec(cis(is_disk() ? 0 : x[2])), before.real(),
                                            before.imag(), after * std::exp(-floor_.spin_drag * x[0])};
        const ContactKinematics<double> u = contact_kinematics(body_, state);
        if (!(u.un > -0.02)) return {};  // somewhat beyond a touch, so that soft impacts have cells about them
        const Impulse<double> law = impulse<rule>(u, scene_.mu, scene_.restitution);
        return {law.normal + flying.impulse.real(), law.tangential - flying.impulse.imag()};
    }

    /// All three: the spin's equation last.
    Unknowns residual(const Unknowns& x, long long j) const {
        const Deficit d = deficit(x, j);
        const Number k = response(x[0]);
        const double spins = is_disk() ? x[2] : (k * place_without_arm(x[1]) * cis(-x[2])).imag() - turning(x[0], j, k);
        return {d.normal, d.tangential, spins};
    }

private:
    struct Flying {
        Number after, impulse;  ///< V just after the impact, and −p + iq
    };

    static Number cis(double angle) { return std::polar(1.0, angle); }
    static Number number(const Vec2<double>& v) { return {v.x, v.y}; }
    static Vec2<double> vec(const Number& z) { return {z.real(), z.imag()}; }

    Flying flight(const Unknowns& x) const {
        const Number place = place_without_arm(x[1]) - body_.alpha * cis(is_disk() ? 0 : x[2]);
        const Number stream = (cis(x[0]) - 1.0) * place / length(x[0]);
        return {stream + number(floor_.carrying) * scene_.beta * cis(-x[1]), response(x[0]) * place};
    }
    /// Of a disk what friction gives it back in each impact.
    double spin(const Unknowns& x, long long j, const Number& impulse) const {
        if (!is_disk()) return (x[0] - spacing() * static_cast<double>(j)) / spin_length(x[0]);
        return body_.alpha * impulse.imag() / (body_.inertia * -std::expm1(-floor_.spin_drag * x[0]));
    }

    Scene<double> scene_;
    Body<double> body_;
    FloorDrag<double> floor_;
};

/// Newton's method; nothing where it leaves the neighbourhood.
template <ImpactRule rule>
std::optional<Unknowns> solved(const Equations<rule>& equations, Unknowns x, long long j, double longest) {
    const Unknowns from = x;
    for (int i = 0; i < 40; ++i) {
        const Unknowns f = equations.residual(x, j);
        if (!f.allFinite()) return {};
        Eigen::Matrix3d d;
        for (int k = 0; k < 3; ++k) {
            constexpr double h = 1e-6;
            Unknowns up = x, down = x;
            up[k] += h;
            down[k] -= h;
            d.col(k) = (equations.residual(up, j) - equations.residual(down, j)) / (2 * h);
        }
        const Unknowns step = d.fullPivLu().solve(-f);
        if (!step.allFinite()) return {};
        x += step * std::min(1.0, 0.2 / step.norm());
        if (!(x[0] > 0.5 * step_of_time && x[0] <= longest && (x - from).norm() < 1)) return {};
        if (step.norm() < 1e-12 && f.norm() < 1e-11) return x;
    }
    return {};
}

/// One value of j and one of the two χ: a row of the grid for each τ.
template <ImpactRule rule>
class Rows {
public:
    Rows(const Equations<rule>& equations, long long j, bool beyond, double widest)
        : equations_(equations), j_(j), beyond_(beyond), widest_(widest) {}

    /// The points from which Newton's method is begun about the cells between τ and the τ of the row before.
    ///   k, places  the response, and 1 + hβ cis(−ψ) at the points
    void row(double tau, const Number& k, const std::vector<Number>& places, std::vector<Unknowns>& starts) {
        std::vector<Point> now(points_of_psi);
        const double turning = equations_.turning(tau, j_, k);
        for (int m = 0; m < points_of_psi; ++m) now[static_cast<std::size_t>(m)] = point(tau, k, turning, places, m);
        for (int m = 0; m < points_of_psi && !before_.empty(); ++m) {
            const auto a = static_cast<std::size_t>(m), b = static_cast<std::size_t>((m + 1) % points_of_psi);
            const Point* const corners[] = {&before_[a], &before_[b], &now[a], &now[b]};
            if (changes(corners, &Deficit::normal) && changes(corners, &Deficit::tangential))
                starts.push_back((before_[a].x + now[a].x) / 2);
        }
        before_ = std::move(now);
    }
    void skip() { before_.clear(); }

private:
    struct Point {
        Unknowns x;
        Deficit left;
    };

    Point point(double tau, const Number& k, double turning, const std::vector<Number>& places, int m) const {
        const double psi = -pi<double>() + 2 * pi<double>() * m / points_of_psi;
        Point point{{tau, psi, 0}, {}};
        if (!equations_.is_disk()) {
            const Number pull = k * places[static_cast<std::size_t>(m)];
            const double sine = turning / std::abs(pull);
            if (!(std::abs(sine) <= 1)) return point;
            const double angle = std::asin(sine);
            point.x[2] = wrapped_angle(std::arg(pull) - (beyond_ ? pi<double>() - angle : angle));
            if (!(std::abs(point.x[2]) <= 1.05 * widest_)) return point;
        }
        point.left = equations_.deficit(point.x, j_);
        return point;
    }

    static bool changes(const Point* const (&corners)[4], double Deficit::*part) {
        bool above = false, below = false;
        for (const Point* corner : corners) {
            above = above || corner->left.*part >= 0;
            below = below || corner->left.*part <= 0;
        }
        return above && below;
    }

    const Equations<rule>& equations_;
    long long j_;
    bool beyond_;
    double widest_;
    std::vector<Point> before_;
};

struct Solution {
    long long j;
    Unknowns x;
};

template <ImpactRule rule>
void add_solutions(const Equations<rule>& equations, long long j, const std::vector<Unknowns>& starts, double longest,
                   double widest, std::vector<Solution>& found) {
    for (const Unknowns& start : starts) {
        auto x = solved(equations, start, j, longest);
        if (!x) continue;
        (*x)[1] = wrapped_angle((*x)[1]);
        if (!(std::abs((*x)[2]) <= widest)) continue;
        const bool known = std::any_of(found.begin(), found.end(), [&](const Solution& other) {
            const Unknowns apart = other.x - *x;
            return other.j == j && std::abs(apart[0]) + std::abs(wrapped_angle(apart[1])) + std::abs(apart[2]) < 1e-7;
        });
        if (!known) found.push_back({j, *x});
    }
}

/// All j with |S| ≤ fastest at some τ up to the longest.
struct Steps {
    long long first = 0, last = 0;
};

template <ImpactRule rule>
Steps steps_of(const Equations<rule>& equations, double longest, double fastest) {
    if (equations.is_disk()) return {};
    const double reach = fastest * equations.spin_length(longest), spacing = equations.spacing();
    return {static_cast<long long>(std::floor(-reach / spacing)),
            static_cast<long long>(std::ceil((longest + reach) / spacing))};
}

template <ImpactRule rule>
std::vector<Solution> solutions(const Equations<rule>& equations, double longest, const DraggedModesOptions& options) {
    const double fastest = options.fastest_spin;
    const double spacing = equations.spacing();
    const double widest =
        equations.is_disk() ? 0 : spacing / 2 - std::asin(equations.body().alpha * std::sin(spacing / 2));
    std::vector<Number> places;
    for (int m = 0; m < points_of_psi; ++m)
        places.push_back(equations.place_without_arm(-pi<double>() + 2 * pi<double>() * m / points_of_psi));
    std::vector<Solution> found;
    const auto [first, last] = steps_of(equations, longest, fastest);
    const int rows = static_cast<int>(std::ceil(longest / step_of_time));
    for (long long j = first; j <= last; ++j)
        for (const bool beyond : {false, true}) {
            if (beyond && equations.is_disk()) continue;
            if (options.stop && options.stop()) return found;
            Rows<rule> grid(equations, j, beyond, widest);
            std::vector<Unknowns> starts;
            for (int i = 1; i <= rows; ++i) {
                const double tau = std::min(longest, i * step_of_time);
                const double spin = (tau - spacing * static_cast<double>(j)) / equations.spin_length(tau);
                if (!equations.is_disk() && std::abs(spin) > fastest)
                    grid.skip();
                else
                    grid.row(tau, equations.response(tau), places, starts);
            }
            add_solutions(equations, j, starts, longest, widest, found);
        }
    return found;
}

/// The longest flight up to which the grids have no more points than are looked at.
template <ImpactRule rule>
double affordable(const Equations<rule>& equations, const DraggedModesOptions& options) {
    const auto points = [&](double longest) {
        const Steps steps = steps_of(equations, longest, options.fastest_spin);
        return 2.0 * static_cast<double>(steps.last - steps.first + 1) * points_of_psi * longest / step_of_time;
    };
    double longest = options.longest_flight;
    while (points(longest) > most_points) longest *= 0.8;
    return longest;
}

template <class Map>
steady::MapOfScene seen_map(const Map& map) {
    const auto kept = std::make_shared<Map>(map);
    return {map.scene(), map.body(), [kept](const SectionPoint<double>& z, bool with_derivative) -> steady::Seen {
                const PostImpactState<double> state = post_impact_state(z);
                const Collision<double> collision = kept->advance(state);
                if (!with_derivative || collision.outcome != FirstContactOutcome::contact) return {collision, {}};
                return {collision, derivative_by_saltation(*kept, state, collision)};
            }};
}

}  // namespace

DraggedModes dragged_modes(const Scene<double>& scene, const DraggedModesOptions& options) {
    validated(scene);
    if (!scene.has_drag()) throw std::invalid_argument("drag = 0: the modes of such a scene are steady_modes");
    if (!(options.longest_flight > 0 && options.longest_flight <= 1e4))
        detail::out_of_range("longest flight", options.longest_flight, "0 to 10000");
    if (!(options.fastest_spin >= 1 && options.fastest_spin <= 1e6))
        detail::out_of_range("fastest spin", options.fastest_spin, "1 to 1000000");
    DraggedModes result;
    if (scene.is_disk() && scene.turning_drag() == 0) return result;
    with_dragged_map(scene, [&](const auto& map) {
        constexpr ImpactRule rule = std::decay_t<decltype(map)>::rule;
        const Equations<rule> equations(scene);
        result.searched_to = affordable(equations, options);
        const steady::MapOfScene seen = seen_map(map);
        for (const Solution& solution : solutions(equations, result.searched_to, options)) {
            ++result.candidates;
            const SectionPoint<double> z = equations.point(solution.x, solution.j);
            if (!(std::abs(z.spin) <= options.fastest_spin) ||
                !(contact_kinematics(map.body(), post_impact_state(z)).un < -1e-9))
                continue;
            const auto branch = std::cos(z.psi) > 0 ? SteadyBranch::plus : SteadyBranch::minus;
            if (auto mode = steady::verified_mode(seen, branch, solution.j, solution.x[0], z))
                result.modes.push_back(*mode);
        }
    });
    std::sort(result.modes.begin(), result.modes.end(),
              [](const SteadyMode& a, const SteadyMode& b) { return a.tau < b.tau; });
    return result;
}

}  // namespace swirl
