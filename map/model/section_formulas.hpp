// States on the section, in which a flight begins and a contact ends, for numbers and for lanes
// (numbers/vec2_formulas.hpp says how).

/// A point of the section with its angles as unit vectors, which is what the map iterates: no arc tangent per impact.
template <class T>
struct PostImpactState {
    Vec2<T> psi;  ///< cis ψ
    Vec2<T> chi;  ///< cis χ
    T vn{}, vt{}, spin{};
};

/// The flight that begins at a point of the section, in the axes (n, t): the struck vertex is at (1, 0), the swirl's
/// arm at angle −ψ.
///   arm  α cis χ
template <class T>
[[gnu::always_inline]] inline Flight<T> flight_with(Vec2<T> arm, T beta, const PostImpactState<T>& post_impact) {
    // From values, number by number: of lanes copied from member to member, GCC keeps a copy on the stack.
    const T spin = post_impact.spin;
    Flight<T> flight;
    flight.centre = {T(1) - arm.x, -arm.y};
    flight.velocity = {post_impact.vn, post_impact.vt};
    flight.phase = conjugate(post_impact.psi);
    flight.arm = arm;
    flight.spin = spin;
    flight.beta = beta;
    flight.struck = true;
    return flight;
}
template <class T>
[[gnu::always_inline]] inline Flight<T> flight_from(const Body<T>& body, const PostImpactState<T>& post_impact) {
    return flight_with(body.unbiased_alpha * post_impact.chi, body.beta, post_impact);
}

/// Slip velocities and lever arms at the contact: u = V + S ẑ×r − O′,
/// u_n = v_n − αS sin χ − β sin ψ, u_t = v_t + αS cos χ − β cos ψ.
template <class T>
[[gnu::always_inline]] inline ContactKinematics<T> contact_kinematics(const Body<T>& body,
                                                                      const PostImpactState<T>& post_impact) {
    const Vec2<T> r = body.alpha * post_impact.chi;
    return {post_impact.vn - post_impact.spin * r.y - body.beta * post_impact.psi.y,
            post_impact.vt + post_impact.spin * r.x - body.beta * post_impact.psi.x,
            r.x,
            r.y,
            body.inertia,
            body.inverse_inertia};
}

/// The state at a contact in its own axes, before the impact: ψ = arg n − arg w, χ = arg r − arg n. The disk's:
///   x       n but for rounding, from the container's centre
///   longer  `missing_length(x)`
///   phase   of the swirl
template <class T>
[[gnu::always_inline]] inline void turn_to_contact(const Vec2<T>& x, const T& longer, const Vec2<T>& phase,
                                                   const Flight<T>& flight, PostImpactState<T>& state) {
    const Vec2<T> seen = seen_from(x, flight.velocity);
    state.psi = renormalised(seen_from(phase, x));
    state.chi = {T(1), T(0)};
    state.vn = seen.x + longer * seen.x;
    state.vt = seen.y + longer * seen.y;
    state.spin = flight.spin;
}

/// A vertex's, at x = X + `arm`.
///   turn     the angle from x to n, which rounding left out
///   missing  … and from the arm to the vertex
template <class T>
[[gnu::always_inline]] inline void turn_to_contact(const Vec2<T>& x, const T& longer, const T& turn, const T& missing,
                                                   const Vec2<T>& phase, const Vec2<T>& arm, const Body<T>& body,
                                                   const Flight<T>& flight, PostImpactState<T>& state) {
    const Vec2<T> seen = seen_from(x, flight.velocity);
    const Vec2<T> velocity = seen + seen_from(Vec2<T>{longer, turn}, seen);
    state.psi = renormalised(seen_from(phase, x), turn);
    state.chi = renormalised(body.unbiased_inverse_alpha * seen_from(x, arm), T(missing - turn));
    state.vn = velocity.x;
    state.vt = velocity.y;
    state.spin = flight.spin;
}

/// What an impulse −p n + q t changes.
template <class T>
[[gnu::always_inline]] inline void apply_impulse(const ContactKinematics<T>& contact, const T& normal,
                                                 const T& tangential, PostImpactState<T>& state) {
    state.vn = state.vn - normal;
    state.vt = state.vt + tangential;
    state.spin = state.spin + (contact.rn * tangential + contact.rt * normal) * contact.inverse_inertia;
}
