#include "apps/studies/scene_map/orbit_ending.hpp"

#include "map/orbit/orbit.hpp"

#include <variant>

namespace swirl::studies {

namespace {

/// What a completed step's speeds say.
Outcome after_impact(const Body<double>& body, const PostImpactState<double>& state) {
    if (has_diverged(body, state)) return Outcome::diverged;
    return has_come_to_rest(body, state) ? Outcome::resting : Outcome::completed;
}

}  // namespace

template <int D>
OrbitBegin begin_orbit(const SceneMap<D>& map, const Start<double>& start) {
    OrbitBegin begin;
    if (const auto* point = std::get_if<SectionPoint<double>>(&start)) {
        require_leaving(map.body(), *point);
        begin.state = post_impact_state(*point);
        return begin;
    }
    const ReturnStep<double> step = map.first_impact(std::get<LabStart<double>>(start));
    begin.outcome = step.outcome;
    if (step.outcome != Outcome::completed) return begin;
    begin.impacts = 1;
    begin.state = step.collision.after;
    begin.outcome = after_impact(map.body(), begin.state);
    return begin;
}

template <int D>
Outcome ending_at(const SceneMap<D>& map, const PostImpactState<double>& last, long long& impacts) {
    const ReturnStep<double> step = map.return_step(last);
    if (step.outcome != Outcome::completed) return step.outcome;
    ++impacts;
    return after_impact(map.body(), step.collision.after);
}

template OrbitBegin begin_orbit(const SceneMap<disk_dimension>&, const Start<double>&);
template OrbitBegin begin_orbit(const SceneMap<polygon_dimension>&, const Start<double>&);
template Outcome ending_at(const SceneMap<disk_dimension>&, const PostImpactState<double>&, long long&);
template Outcome ending_at(const SceneMap<polygon_dimension>&, const PostImpactState<double>&, long long&);

}  // namespace swirl::studies
