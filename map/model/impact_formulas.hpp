// The contact of an impact, for numbers and for lanes (numbers/vec2_formulas.hpp says how).

/// Everything that the impulse depends on, in the axes (n, t) of the contact; mass 1.
template <class T>
struct ContactKinematics {
    T un{};                              ///< normal slip velocity before, > 0 when approaching
    T ut{};                              ///< tangential slip velocity before
    T rn{};                              ///< offset from the body's centre to the contact, along n
    T rt{};                              ///< … along t
    T inertia = T(1);                    ///< I
    T inverse_inertia = T(1) / inertia;  ///< 1/I

    [[gnu::always_inline]] T b1() const { return T(1) + rn * rn * inverse_inertia; }
    [[gnu::always_inline]] T b2() const { return T(1) + rt * rt * inverse_inertia; }
    [[gnu::always_inline]] T b3() const { return rn * rt * inverse_inertia; }
    /// B₂ − B₃²/B₁ = (1 + r²/I)/B₁, dC/dp while sticking: a sum, where the difference is rounding for a small I.
    [[gnu::always_inline]] T sticking() const { return (b2() + rn * rn * inverse_inertia) / b1(); }
};
