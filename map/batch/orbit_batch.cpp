#include "map/batch/orbit_batch.hpp"

#include "map/contact/chatter_completion.hpp"

#include <cstdint>

namespace swirl::detail {

namespace {

void fill_factor(const UnbiasedFactor<double>& factor, int lane, LaneFactors& factors) {
    factors.first.of[lane] = factor.first;
    factors.second.of[lane] = factor.second;
}

}  // namespace

void fill_scene(const Body<double>& body, double mu, double restitution, double widest_sine, int lane,
                LaneBlock& block) {
    LaneScenes& s = block.scenes;
    s.alpha.of[lane] = body.alpha;
    s.beta.of[lane] = body.beta;
    s.inverse_inertia.of[lane] = body.inverse_inertia;
    s.inverse_inner.of[lane] = body.inverse_inner;
    s.disk_grip.of[lane] = body.disk_grip;
    s.inner.of[lane] = body.inner;
    s.outer.of[lane] = body.outer;
    fill_factor(body.unbiased_alpha, lane, s.unbiased_alpha);
    fill_factor(body.unbiased_inverse_alpha, lane, s.unbiased_inverse_alpha);
    fill_factor(body.unbiased_inner, lane, s.unbiased_inner);
    fill_factor(body.unbiased_inverse_inner, lane, s.unbiased_inverse_inner);
    s.mu.of[lane] = mu;
    s.restitution.of[lane] = restitution;
    s.chatter.of[lane] = chatter_tolerance<double>() * (1 - restitution);
    s.widest_sine.of[lane] = widest_sine;
    s.sides.of[lane] = body.sides;
    s.spacing.of[lane] = body.spacing;
    s.per_spacing.of[lane] = body.per_spacing;
    s.half_slope.of[lane] = body.half_slope;
    s.side.of[lane] = body.side;
    s.next_turn_x.of[lane] = body.next_turn.x;
    s.next_turn_y.of[lane] = body.next_turn.y;
}

void fill_state(const PostImpactState<double>& state, int lane, LaneBlock& block) {
    block.psi_x.of[lane] = state.psi.x;
    block.psi_y.of[lane] = state.psi.y;
    block.chi_x.of[lane] = state.chi.x;
    block.chi_y.of[lane] = state.chi.y;
    block.vn.of[lane] = state.vn;
    block.vt.of[lane] = state.vt;
    block.spin.of[lane] = state.spin;
    block.guess.of[lane] = 0;
    block.looks.of[lane] = 0;
}

RoundResult advance_lanes(const KernelKind& kind, LaneBlock& block) {
    const auto advance = kind.shape == Shape::disk ? advance_disks : advance_polygons;
    return advance(kind.rule, kind.sums_chatter, block);
}

std::int64_t VertexTables::add(const Body<double>& body) {
    for (const auto& [sides, begin] : begins_)
        if (sides == body.sides) return begin;
    const auto begin = static_cast<std::int64_t>(numbers_.size() / 4);
    begins_.emplace_back(body.sides, begin);
    for (std::size_t k = 0; k < body.vertices.size(); ++k)
        numbers_.insert(numbers_.end(), {body.vertices[k].x, body.vertices[k].y, body.rests[k].x, body.rests[k].y});
    return begin;
}

}  // namespace swirl::detail
