// The centre's gap along a flight in lanes: map/first_contact/circle_path.hpp and gap_series.hpp.
#if defined(SWIRL_MAP_BATCH_PATH_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef SWIRL_MAP_BATCH_PATH_INL
#undef SWIRL_MAP_BATCH_PATH_INL
#else
#define SWIRL_MAP_BATCH_PATH_INL
#endif

#include "map/batch/turns-inl.hpp"
#include "map/first_contact/certificate.hpp"

HWY_BEFORE_NAMESPACE();
namespace swirl::detail::HWY_NAMESPACE {

inline constexpr double unit_roundoff = 0x1p-52;

struct LaneGap {
    Lane value, rate, curvature, jerk;
};

/// What a round reads of a flight.
struct LaneFlight {
    Plane centre, velocity, phase, arm, swirl;  ///< swirl: β·phase
    Lane spin, beta;
};

struct LanePath {
    Lane slope, speed2, a0, a1, b0, b1;
};

struct LaneStart {
    Lane rate, curvature, jerk, fourth, fifth;
};

HWY_INLINE LanePath circle_path(const LaneFlight& flight) {
    const Plane place = flight.centre + flight.swirl;
    const Plane side = quarter_turned(flight.swirl);
    return {Lane(2) * dot(flight.velocity, flight.centre),
            dot(flight.velocity, flight.velocity),
            dot(place, flight.swirl),
            dot(flight.velocity, flight.swirl),
            dot(flight.centre, side),
            dot(flight.velocity, side)};
}

HWY_INLINE LanePath circle_path_from_wall(LaneFactor inner, const LaneFlight& flight) {
    LanePath path = circle_path(flight);
    path.slope = Lane(2) * (inner * flight.velocity.x);
    path.b0 = -(inner * flight.swirl.y);
    return path;
}

HWY_INLINE LaneStart gap_at_start(const LanePath& path) {
    LaneStart gap;
    gap.rate = path.slope - Lane(2) * path.b0;
    gap.curvature = Lane(2) * (path.speed2 + (path.a0 - Lane(2) * path.b1));
    gap.jerk = Lane(2) * (path.b0 + Lane(3) * path.a1);
    gap.fourth = Lane(2) * (Lane(4) * path.b1 - path.a0);
    gap.fifth = Lane(-2) * (path.b0 + Lane(5) * path.a1);
    return gap;
}

HWY_INLINE Lane return_guess(const LaneStart& start) {
    const Lane n = -start.rate;
    const Lane d = Lane(0.5) * start.curvature;
    const Lane n2 = n * n;
    const Lane d2 = d * d;
    const Lane cubic = fraction(1, 6) * start.jerk * d2;
    const Lane quartic = fraction(1, 24) * start.fourth * (n * d);
    const Lane quintic = fraction(1, 120) * start.fifth * n2;
    const Lane slope = d2 * d2 + n * (Lane(2) * cubic + (Lane(3) * quartic + Lane(4) * quintic));
    const Lane value = n * (cubic + (quartic + quintic));
    const Lane left = slope - value;
    const Mask usual = all(slope > Lane(0), left > Lane(0.25) * slope, left < Lane(4) * slope);
    return choose(usual, n * left, n) / choose(usual, d * slope, d);
}

struct LaneSeries {
    Lane c[11];
};

template <int terms>
HWY_INLINE LaneSeries series_along(const LanePath& path, const Moment& at) {
    const Lane c = at.turn.x;
    const Lane s = at.turn.y;
    const Lane a = path.a0 + path.a1 * at.time;
    const Lane b = path.b0 + path.b1 * at.time;
    const Lane ac = a * c + b * s;
    const Lane v = path.a1 * c + path.b1 * s;
    const Lane along = a + ac;
    const Lane across = b + (b * c - a * s);
    const Lane v_along = path.a1 + v;
    const Lane v_across = path.b1 + (path.b1 * c - path.a1 * s);
    const Lane twice = path.speed2 * at.time;
    LaneSeries g;
    g.c[0] = (at.time * (path.slope + twice) - Lane(2) * ac) - Lane(2) * (a * at.rest.x + b * at.rest.y);
    g.c[1] = (path.slope + (twice + twice)) - Lane(2) * (v + across);
    g.c[2] = path.speed2 + (along - Lane(2) * v_across);
    g.c[3] = fraction(1, 3) * (across + Lane(3) * v_along);
    g.c[4] = fraction(1, 12) * (Lane(4) * v_across - along);
    if constexpr (terms > 5) {
        g.c[5] = fraction(-1, 60) * (across + Lane(5) * v_along);
        g.c[6] = fraction(1, 360) * (along - Lane(6) * v_across);
        g.c[7] = fraction(1, 2520) * (across + Lane(7) * v_along);
        g.c[8] = fraction(1, 20160) * (Lane(8) * v_across - along);
        g.c[9] = fraction(-1, 181440) * (across + Lane(9) * v_along);
        g.c[10] = fraction(1, 1814400) * (along - Lane(10) * v_across);
    }
    return g;
}

HWY_INLINE Lane householder(const LaneSeries& g) {
    const Lane* c = g.c;
    const Lane square = c[1] * c[1];
    const Lane r = c[0] * c[2];
    const Lane t = c[0] * c[0] * c[3];
    const Lane third = c[1] * (square - (r + r)) + t;
    const Lane fourth =
        square * (square - c[0] * (Lane(3) * c[2])) + (r * r + (Lane(2) * c[1] * t - c[0] * c[0] * (c[0] * c[4])));
    return -(c[0] * third) / fourth;
}

struct InnerLanes {
    Lane first, second, third, fourth;
};

HWY_INLINE InnerLanes inner_coefficients(const LaneGap& from, const LaneGap& to, Lane h, Lane sixth) {
    const Lane h2 = h * h;
    const Lane remainder = sixth * (h2 * h2 * h2) * fraction(1, 14400);
    return {from.value + fraction(1, 5) * h * from.rate,
            from.value + fraction(2, 5) * h * from.rate + fraction(1, 20) * h2 * from.curvature + remainder,
            to.value - fraction(2, 5) * h * to.rate + fraction(1, 20) * h2 * to.curvature + remainder,
            to.value - fraction(1, 5) * h * to.rate};
}

HWY_INLINE Mask clear_between(const LaneGap& from, const LaneGap& to, Lane h, Lane sixth) {
    const Lane rounding(4 * unit_roundoff);
    const InnerLanes c = inner_coefficients(from, to, h, sixth);
    return all(c.first <= rounding, c.second <= rounding, c.third <= rounding, c.fourth <= rounding,
               from.value <= rounding, to.value <= rounding);
}

/// Bounds of |g⁽ᵏ⁾| of the centre's gap.
HWY_INLINE Lane centre_bound(double k, Lane beta, Lane outer, Lane speed) {
    const Lane place = outer + beta;
    return Lane(2) * beta * (Lane(k) * speed + place);
}

}  // namespace swirl::detail::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
