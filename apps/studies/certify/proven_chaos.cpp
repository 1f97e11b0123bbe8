#include "apps/studies/certify/proven_chaos.hpp"

#include "apps/studies/certify/saddles.hpp"
#include "apps/studies/parallel/pieces.hpp"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <utility>

namespace swirl::studies::certify {

namespace {

proof::SectionSet stated(const FramedSet& set) {
    proof::SectionSet result;
    result.centre.assign(set.point.data(), set.point.data() + set.point.size());
    const Eigen::MatrixXd matrix = set.matrix();
    for (Eigen::Index i = 0; i < matrix.rows(); ++i)
        for (Eigen::Index j = 0; j < matrix.cols(); ++j) result.matrix.push_back(matrix(i, j));
    return result;
}

/// All that is tried: sets, the links between them, and which orbit a link belongs to (0: a cycle's own).
struct Attempt {
    std::vector<FramedSet> sets;
    proof::ChaosClaim claim;
    std::vector<std::size_t> orbit_of;  ///< link → orbit from 1, or cycle
    std::vector<bool> is_cycle;

    std::size_t add(const FramedSet& set) {
        sets.push_back(set);
        claim.sets.push_back(stated(set));
        return sets.size() - 1;
    }
    void link(std::size_t from, std::size_t to, std::size_t owner, bool cycle) {
        const Letter letter = letter_from(sets[from].letter);
        claim.links.push_back({from, to, {letter.vertex_step, letter.mode, 0}, sets[from].duration, {}});
        orbit_of.push_back(owner);
        is_cycle.push_back(cycle);
    }
    /// No common point with what set `from` is carried over already: paths that part there stay apart.
    bool has_room(const ChartMap& map, std::size_t from, const FramedSet& next) const {
        return std::none_of(claim.links.begin(), claim.links.end(), [&](const proof::CoveringClaim& link) {
            return link.from == from && !are_apart(map, sets[link.to], next);
        });
    }
};

/// The largest sets about a cycle's points that are proven to be carried over each other: those that samples allow,
/// ever smaller until a proof in few pieces succeeds.
Saddle proven_saddle(const Scene<double>& scene, const ChartMap& map, const CyclePlace& place, const SetShape& shape,
                     const ChaosOptions& options) {
    constexpr int few_pieces = 600;
    constexpr double narrowest = 1e-7;
    double widest = shape.widest;
    Saddle saddle;
    for (std::string why; widest > narrowest; widest = 0.5 * saddle.sets.front().width) {
        saddle = saddle_at(map, map.chart_of(place.points.front()), static_cast<int>(place.points.size()), widest,
                           shape.aspect);
        if (saddle.sets.empty() || options.control.is_stopped()) break;
        Attempt attempt;
        attempt.claim.jacobi = map.jacobi();
        for (const FramedSet& set : saddle.sets) attempt.add(set);
        for (std::size_t i = 0; i < saddle.sets.size(); ++i) attempt.link(i, (i + 1) % saddle.sets.size(), 0, true);
        bool good = true;
        for (const proof::CoveringClaim& link : attempt.claim.links) {
            const proof::CoveringProof proof = proof::prove_covering(scene, attempt.claim, link, few_pieces);
            good = good && proof.proven;
            if (!proof.proven) why = proof.reason;
            if (!good) break;
        }
        if (good) break;
        saddle.reason = why;
    }
    if (!saddle.reason.empty()) saddle.sets.clear();
    saddle.number = place.number;
    return saddle;
}

/// The cycles' saddles in their order; `found.cycles` says why one has none.
std::vector<Saddle> saddles_of(const ChartMap& map, const std::vector<CyclePlace>& places, const SetShape& shape,
                               const ChaosOptions& options, Attempt& attempt, ProvenChaos& found) {
    const auto tried = std::make_shared<std::vector<Saddle>>(places.size());
    const auto work = std::make_shared<const std::vector<CyclePlace>>(places);
    const Scene<double> scene = found.scene;
    run_pieces(places.size(), "cycles", options.control,
               [scene, map, work, tried, shape, options](std::size_t i) -> KeepResult {
                   auto saddle = proven_saddle(scene, map, (*work)[i], shape, options);
                   return [tried, i, saddle = std::move(saddle)] { (*tried)[i] = saddle; };
               });
    std::vector<Saddle> saddles;
    for (std::size_t i = 0; i < places.size(); ++i) {
        Saddle& saddle = (*tried)[i];
        ChaosCycle cycle;
        cycle.number = places[i].number;
        cycle.period = places[i].points.size();
        cycle.multiplier = saddle.multiplier;
        cycle.reason = saddle.number == 0 ? "it was not tried" : saddle.reason;
        if (cycle.reason.empty()) {
            cycle.first_set = attempt.sets.size();
            for (const FramedSet& set : saddle.sets) attempt.add(set);
            for (std::size_t k = 0; k < saddle.sets.size(); ++k)
                attempt.link(cycle.first_set + k, cycle.first_set + (k + 1) % saddle.sets.size(), found.cycles.size(),
                             true);
            saddles.push_back(saddle);
        }
        found.cycles.push_back(cycle);
    }
    return saddles;
}

std::vector<Connection> all_connections(const ChartMap& map, const std::vector<Saddle>& saddles,
                                        const ChaosOptions& options) {
    const auto parts = std::make_shared<const std::vector<ScanPart>>(scan_parts(saddles, options.scan));
    const auto results = std::make_shared<std::vector<std::vector<Connection>>>(parts->size());
    const auto work = std::make_shared<const std::vector<Saddle>>(saddles);
    run_pieces(parts->size(), "orbits", options.control,
               [map, work, parts, results, options](std::size_t i) -> KeepResult {
                   auto found = connections_in(map, *work, (*parts)[i], options.longest_link, options.control.stop);
                   return [results, i, found = std::move(found)] { (*results)[i] = found; };
               });
    std::vector<Connection> all;
    for (const auto& some : *results) all.insert(all.end(), some.begin(), some.end());
    std::stable_sort(all.begin(), all.end(),
                     [](const Connection& x, const Connection& y) { return x.sets.size() < y.sets.size(); });
    return all;
}

/// Of which cycles some way leads to which, by number.
std::set<std::pair<std::size_t, std::size_t>> ways_between(const std::vector<Connection>& connections) {
    std::set<std::pair<std::size_t, std::size_t>> ways;
    for (const Connection& connection : connections) ways.emplace(connection.from, connection.to);
    for (std::size_t before = 0; before != ways.size();) {
        before = ways.size();
        const auto known = ways;
        for (const auto& [a, b] : known)
            for (const Connection& connection : connections)
                if (connection.from == b) ways.emplace(a, connection.to);
    }
    return ways;
}

/// The shortest orbits that some way leads back from.
void add_orbits(const ChartMap& map, const std::vector<Connection>& connections, const ChaosOptions& options,
                Attempt& attempt, ProvenChaos& found) {
    std::map<std::size_t, std::size_t> first_set;
    for (const ChaosCycle& cycle : found.cycles)
        if (cycle.reason.empty()) first_set[cycle.number] = cycle.first_set;
    const std::set<std::pair<std::size_t, std::size_t>> ways = ways_between(connections);
    for (const Connection& connection : connections) {
        if (connection.from != connection.to && ways.count({connection.to, connection.from}) == 0) continue;
        if (found.orbits.size() >= static_cast<std::size_t>(options.most_links)) return;
        std::size_t last = first_set.at(connection.from) + connection.from_set;
        if (!attempt.has_room(map, last, connection.sets.front())) continue;
        ChaosLink orbit{connection.from, connection.to, attempt.sets.size(), connection.sets.size(), false, {}};
        const std::size_t owner = found.orbits.size();
        for (const FramedSet& set : connection.sets) {
            const std::size_t now = attempt.add(set);
            attempt.link(last, now, owner, false);
            last = now;
        }
        attempt.link(last, first_set.at(connection.to) + connection.to_set, owner, false);
        found.orbits.push_back(std::move(orbit));
    }
}

/// Each link's proof; none of those that a stop left.
std::vector<std::optional<proof::CoveringProof>> proofs_of(const Scene<double>& scene, const Attempt& attempt,
                                                           const ChaosOptions& options, bool& whole) {
    const auto claim = std::make_shared<const proof::ChaosClaim>(attempt.claim);
    const auto results = std::make_shared<std::vector<std::optional<proof::CoveringProof>>>(attempt.claim.links.size());
    const int most = options.most_pieces;
    whole = run_pieces(claim->links.size(), "links", options.control,
                       [scene, claim, results, most](std::size_t i) -> KeepResult {
                           auto proof = proof::prove_covering(scene, *claim, claim->links[i], most);
                           return [results, i, proof = std::move(proof)] { (*results)[i] = proof; };
                       });
    return *results;
}

/// What is proven as a claim of its own: the sets that some proven cycle or orbit has.
void keep_proven(const ChartMap& map, const Attempt& attempt,
                 const std::vector<std::optional<proof::CoveringProof>>& proofs, ProvenChaos& found) {
    std::vector<std::string> cycle_fails(found.cycles.size()), orbit_fails(found.orbits.size());
    for (std::size_t k = 0; k < proofs.size(); ++k) {
        if (proofs[k] && proofs[k]->proven) continue;
        std::string& why = (attempt.is_cycle[k] ? cycle_fails : orbit_fails)[attempt.orbit_of[k]];
        if (why.empty()) why = proofs[k] ? proofs[k]->reason : "it was not tried";
    }
    std::set<std::size_t> good_cycles;
    for (std::size_t i = 0; i < found.cycles.size(); ++i) {
        ChaosCycle& cycle = found.cycles[i];
        if (cycle.reason.empty()) cycle.reason = cycle_fails[i];
        if (cycle.reason.empty()) good_cycles.insert(cycle.number);
    }
    std::vector<bool> wanted(attempt.sets.size(), false);
    for (std::size_t i = 0; i < found.orbits.size(); ++i) {
        ChaosLink& orbit = found.orbits[i];
        orbit.reason = orbit_fails[i];
        if (orbit.reason.empty() && (good_cycles.count(orbit.from) == 0 || good_cycles.count(orbit.to) == 0))
            orbit.reason = "one of its cycles has no proven sets";
        orbit.proven = orbit.reason.empty();
        for (std::size_t k = 0; orbit.proven && k < orbit.sets; ++k) wanted[orbit.first_set + k] = true;
    }
    for (const ChaosCycle& cycle : found.cycles)
        for (std::size_t k = 0; cycle.reason.empty() && k < cycle.period; ++k) wanted[cycle.first_set + k] = true;
    std::vector<std::size_t> place(attempt.sets.size());
    found.claim.jacobi = attempt.claim.jacobi;
    for (std::size_t i = 0; i < wanted.size(); ++i) {
        if (!wanted[i]) continue;
        place[i] = found.claim.sets.size();
        found.claim.sets.push_back(attempt.claim.sets[i]);
    }
    for (std::size_t k = 0; k < proofs.size(); ++k) {
        proof::CoveringClaim link = attempt.claim.links[k];
        if (!proofs[k] || !proofs[k]->proven || !wanted[link.from] || !wanted[link.to]) continue;
        const ChartStep step = map.step(attempt.sets[link.from].point);
        if (step.alive) link.image = map.point_of(step.state);
        link.from = place[link.from];
        link.to = place[link.to];
        found.claim.links.push_back(link);
        found.pieces.push_back(proofs[k]->pieces);
    }
    for (ChaosCycle& cycle : found.cycles)
        if (cycle.reason.empty()) cycle.first_set = place[cycle.first_set];
    for (ChaosLink& orbit : found.orbits)
        if (orbit.proven) orbit.first_set = place[orbit.first_set];
}

std::vector<std::pair<std::size_t, std::size_t>> pairs_of(const proof::ChaosClaim& claim) {
    std::vector<std::pair<std::size_t, std::size_t>> pairs;
    for (const proof::CoveringClaim& link : claim.links) pairs.emplace_back(link.from, link.to);
    return pairs;
}

/// The bound, or why there is none.
void bound_growth(const Scene<double>& scene, ProvenChaos& found) {
    for (const proof::CoveringClaim& one : found.claim.links)
        for (const proof::CoveringClaim& other : found.claim.links) {
            if (one.from != other.from || one.to >= other.to) continue;
            found.reason = proof::common_point(scene, found.claim, one.to, other.to);
            if (!found.reason.empty()) return;
        }
    found.bound = proof::growth_bound(found.claim.sets.size(), pairs_of(found.claim));
}

/// The first thing that went wrong, in words.
std::string missing(const ProvenChaos& found) {
    for (const ChaosLink& orbit : found.orbits)
        if (!orbit.reason.empty()) return orbit.reason;
    for (const ChaosCycle& cycle : found.cycles)
        if (!cycle.reason.empty()) return cycle.reason;
    return found.cycles.empty() ? "there is no cycle" : "no orbit that leads back to a cycle was found";
}

}  // namespace

ProvenChaos proven_chaos(const Scene<double>& scene, const std::vector<CyclePlace>& places,
                         const ChaosOptions& options) {
    proof::require_chart(scene);
    ProvenChaos found;
    found.scene = scene;
    found.exponent = std::nan("");
    if (places.empty()) {
        found.reason = missing(found);
        return found;
    }
    const ChartMap map(scene, places.front().points.front());
    Attempt attempt;
    const ProvenChaos blank = found;
    double most = -1;
    for (const SetShape& shape : options.shapes) {  // which suits is not known before
        ProvenChaos now = blank;
        Attempt tried;
        tried.claim.jacobi = map.jacobi();
        const std::vector<Saddle> saddles = saddles_of(map, places, shape, options, tried, now);
        const std::vector<Connection> connections = all_connections(map, saddles, options);
        now.found = connections.size();
        add_orbits(map, connections, options, tried, now);
        const double growth = proof::growth_bound(tried.sets.size(), pairs_of(tried.claim)).growth;
        if (options.control.is_stopped() && most >= 0) break;
        if (growth <= most) continue;
        most = growth;
        found = std::move(now);
        attempt = std::move(tried);
    }
    keep_proven(map, attempt, proofs_of(scene, attempt, options, found.whole), found);
    found.whole = found.whole && !options.control.is_stopped();
    bound_growth(scene, found);
    if (!attempt.sets.empty()) {
        const FramedSet& first = attempt.sets.front();
        found.exponent =
            largest_exponent(map, first.point + first.frame.direction * (0.37 * first.width), options.exponent_impacts);
    }
    if (!found.proven() && found.reason.empty()) found.reason = missing(found);
    return found;
}

std::vector<CarriedPoint> carried_points(const ProvenChaos& found, int count) {
    std::vector<CarriedPoint> points;
    const proof::ChaosClaim& claim = found.claim;
    if (claim.links.empty()) return points;
    const ChartMap map(found.scene, claim.links.front().image);  // on its level of J
    const auto centre_of = [](const proof::SectionSet& set) {
        return Eigen::Map<const Eigen::VectorXd>(set.centre.data(), static_cast<Eigen::Index>(set.centre.size()));
    };
    const auto matrix_of = [](const proof::SectionSet& set) {
        const auto n = static_cast<Eigen::Index>(set.centre.size());
        return Eigen::Map<const Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>>(
            set.matrix.data(), n, n);
    };
    for (std::size_t k = 0; k < claim.links.size(); ++k) {
        const proof::SectionSet &from = claim.sets[claim.links[k].from], &to = claim.sets[claim.links[k].to];
        const Eigen::PartialPivLU<Eigen::MatrixXd> inverse(matrix_of(to));
        for (const double side : {-1.0, 0.0, 1.0})
            for (int i = 0; i < count; ++i) {
                Eigen::VectorXd own = Eigen::VectorXd::Zero(map.dimension());
                own[0] = 2.0 * i / (count - 1) - 1, own[1] = side;
                const ChartStep step = map.step(centre_of(from) + matrix_of(from) * own);
                if (!step.alive) continue;
                const Eigen::VectorXd at = inverse.solve(map.difference(step.state, centre_of(to)));
                points.push_back({k, own[0], side, at[0], at[1]});
            }
    }
    return points;
}

}  // namespace swirl::studies::certify
