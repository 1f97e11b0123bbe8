#include "apps/studies/certify/proven_branches.hpp"

#include "analysis/cycles/cycle.hpp"
#include "apps/studies/parallel/pieces.hpp"
#include "apps/studies/scene_map/section_coordinates.hpp"
#include "apps/studies/scene_map/shooting_map.hpp"
#include "map/model/parameter.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <memory>
#include <optional>
#include <utility>

namespace swirl::studies::certify {

namespace {

using proof::BranchBox;

std::array<double, 5> coordinates(const SectionPoint<double>& z) {
    return {z.psi, z.chi, z.vn, z.vt, z.spin};
}

/// Unknown number `index` of a cycle; nothing for a flight's time, which a record does not have.
std::optional<double> unknown_of(const CyclePlace& place, Parameter parameter, std::size_t index) {
    const bool disk = place.scene.is_disk();
    const std::size_t width = disk ? 5 : 6, step = index / width, at = index % width;
    if (step >= place.points.size()) {
        Scene<double> scene = place.scene;
        return number_of(scene, parameter);
    }
    if (at + 1 == width) return std::nullopt;
    return coordinates(place.points[step])[disk && at > 0 ? at + 1 : at];
}

bool is_angle(const CyclePlace& place, std::size_t index) {
    const bool disk = place.scene.is_disk();
    const std::size_t width = disk ? 5 : 6;
    return index / width < place.points.size() && index % width < (disk ? 1U : 2U);
}

/// The cycle lies in the box: in its running unknown's range, and no farther from its middle than the box's cycles.
bool lies_in(const BranchBox& box, const CyclePlace& place, Parameter parameter) {
    constexpr double off = 1e-7;  // that a recorded cycle may be off by
    for (std::size_t i = 0; i < box.middle.size(); ++i) {
        const auto value = unknown_of(place, parameter, i);
        if (!value) continue;
        double away = *value - box.middle[i];
        if (is_angle(place, i)) away = std::remainder(away, 2 * pi<double>());
        const double low = i == box.running ? box.low - box.middle[i] : -box.within;
        const double high = i == box.running ? box.high - box.middle[i] : box.within;
        if (!(away >= low - off && away <= high + off)) return false;
    }
    return true;
}

double distance(const CyclePlace& a, const CyclePlace& b, Parameter parameter, double range) {
    const std::size_t width = a.scene.is_disk() ? 5 : 6, count = width * a.points.size() + 1;
    double sum = 0;
    for (std::size_t i = 0; i < count && a.points.size() == b.points.size(); ++i) {
        const auto x = unknown_of(a, parameter, i), y = unknown_of(b, parameter, i);
        if (!x || !y) continue;
        double away = *x - *y;
        if (is_angle(a, i)) away = std::remainder(away, 2 * pi<double>());
        away /= i + 1 == count ? range : std::max(1.0, std::abs(*x));
        sum += away * away;
    }
    return std::sqrt(sum);
}

bool is_same_word(const std::vector<proof::Branch>& a, const std::vector<proof::Branch>& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const proof::Branch& x, const proof::Branch& y) {
        return x.vertex_step == y.vertex_step && x.mode == y.mode;
    });
}

/// What the map says of a recorded cycle.
struct Judged {
    std::vector<proof::Branch> word;  ///< empty: it is none that a branch is proven of
    int outside = 0;                  ///< multipliers, by double arithmetic
};

Judged judged(const CyclePlace& place) {
    Judged result{candidate_at(place).claim.itinerary, 0};
    const analysis::ShootingMap map = shooting_map_of(place.scene);
    Eigen::MatrixXd product = Eigen::MatrixXd::Identity(map.dimension, map.dimension);
    for (const SectionPoint<double>& z : place.points) {
        const analysis::ShootingStep step = map.step(coordinates_of(z, place.scene.is_disk()), 0);
        if (!step.alive) return {};
        product = step.by_state * product;
    }
    result.outside = analysis::index_of(analysis::sorted_multipliers(product));
    return result;
}

/// What one branch of a record gave.
struct Cover {
    RecordedBranch recorded;
    std::vector<CertifiedBranch> branches;
};

Cover cover_branch(RecordedBranch recorded, const ParameterRange& along, const std::function<bool()>& stop) {
    const std::size_t count = recorded.places.size();
    std::vector<Judged> known;
    for (const CyclePlace& place : recorded.places) known.push_back(judged(place));
    std::vector<bool> tried(count, false), covered(count, false), together(count, false);
    Cover cover;
    // From the middle of the longest stretch that is open: its ends are where cycles end.
    while (!stop()) {
        std::size_t best = 0, length = 0;
        for (std::size_t i = 0; i < count;) {
            std::size_t end = i;
            while (end < count && !tried[end] && !covered[end]) ++end;
            if (end - i > length) {
                length = end - i;
                best = i + length / 2;
            }
            i = end + 1;
        }
        if (length == 0) break;
        tried[best] = true;
        CertifiedBranch branch = proven_branch_at(recorded.places[best], along, stop);
        std::vector<bool> on(count, false);
        for (std::size_t i = 0; i < count; ++i)
            on[i] = is_same_word(known[i].word, branch.proof.itinerary) &&
                    std::any_of(branch.proof.boxes.begin(), branch.proof.boxes.end(), [&](const BranchBox& box) {
                        return (!box.decided || box.outside == known[i].outside) &&
                               lies_in(box, recorded.places[i], *along.parameter);
                    });
        for (std::size_t i = 0; i < count; ++i) {
            covered[i] = covered[i] || on[i];
            if (i + 1 < count && on[i] && on[i + 1]) together[i] = true;
        }
        if (branch.proof.proven()) cover.branches.push_back(std::move(branch));
    }
    for (std::size_t i = 0; i + 1 < count; ++i) {
        const double chord =
            distance(recorded.places[i], recorded.places[i + 1], *along.parameter, along.high - along.low);
        recorded.length += chord;
        if (together[i]) recorded.proven_length += chord;
    }
    cover.recorded = std::move(recorded);
    return cover;
}

/// The cycle that it was followed from lies on one of the others, with the same word.
bool is_known(const std::vector<CertifiedBranch>& others, const CertifiedBranch& branch, const CyclePlace& place,
              Parameter parameter) {
    return std::any_of(others.begin(), others.end(), [&](const CertifiedBranch& other) {
        return is_same_word(other.proof.itinerary, branch.proof.itinerary) &&
               std::any_of(other.proof.boxes.begin(), other.proof.boxes.end(),
                           [&](const BranchBox& box) { return lies_in(box, place, parameter); });
    });
}

}  // namespace

std::vector<StabilitySpan> CertifiedBranch::spans() const {
    std::vector<StabilitySpan> spans;
    for (const BranchBox& box : proof.boxes) {
        const auto stability = box.stability();
        if (spans.empty() || spans.back().stability != stability ||
            (box.decided && spans.back().outside != box.outside))
            spans.push_back({stability, box.outside, box.parameter_begin, box.parameter_end, 0});
        spans.back().end = box.parameter_end;
        spans.back().length += box.length;
    }
    return spans;
}

double CertifiedBranch::length() const {
    double sum = 0;
    for (const BranchBox& box : proof.boxes) sum += box.length;
    return sum;
}

double CertifiedBranch::decided_share() const {
    double sum = 0;
    for (const BranchBox& box : proof.boxes) sum += box.decided ? box.length : 0;
    return proof.boxes.empty() ? 0 : sum / length();
}

std::size_t ProvenBranches::proven() const {
    return static_cast<std::size_t>(std::count_if(branches.begin(), branches.end(),
                                                  [](const CertifiedBranch& branch) { return branch.proof.proven(); }));
}

std::size_t ProvenBranches::boxes() const {
    std::size_t sum = 0;
    for (const CertifiedBranch& branch : branches) sum += branch.proof.boxes.size();
    return sum;
}

double ProvenBranches::proven_share() const {
    double all = 0, proven = 0;
    for (const RecordedBranch& branch : recorded) {
        all += branch.length;
        proven += branch.proven_length;
    }
    return all > 0 ? proven / all : 0;
}

CertifiedBranch proven_branch_at(const CyclePlace& place, const ParameterRange& along,
                                 const std::function<bool()>& stop) {
    CertifiedBranch branch{place.number, place.scene, place.points.size(), {}};
    const Candidate candidate = candidate_at(place);
    if (candidate.reason.empty())
        branch.proof =
            proof::prove_branch({place.scene, candidate.claim, *along.parameter, along.low, along.high}, stop);
    else
        branch.proof.reason = candidate.reason;
    return branch;
}

std::vector<CertifiedBranch> prove_branches(std::vector<CyclePlace> places, const ParameterRange& along,
                                            const RunControl& control) {
    const auto work = std::make_shared<const std::vector<CyclePlace>>(std::move(places));
    const auto results = std::make_shared<std::vector<std::optional<CertifiedBranch>>>(work->size());
    const std::function<bool()> stop = control.stop ? control.stop : [] { return false; };
    run_pieces(work->size(), "certify", control, [work, results, along, stop](std::size_t i) -> KeepResult {
        CertifiedBranch branch = proven_branch_at((*work)[i], along, stop);
        return [results, i, branch = std::move(branch)] { (*results)[i] = branch; };
    });
    std::vector<CertifiedBranch> branches;
    for (std::size_t i = 0; i < results->size(); ++i)
        if (auto& branch = (*results)[i])
            if (!is_known(branches, *branch, (*work)[i], *along.parameter)) branches.push_back(std::move(*branch));
    return branches;
}

ProvenBranches cover_branches(const Scene<double>& scene, std::vector<RecordedBranch> recorded,
                              const ParameterRange& along, const RunControl& control) {
    const auto work = std::make_shared<const std::vector<RecordedBranch>>(std::move(recorded));
    const auto results = std::make_shared<std::vector<std::optional<Cover>>>(work->size());
    const std::function<bool()> stop = control.stop ? control.stop : [] { return false; };
    ProvenBranches all{scene, along, {}, {}, true, true};
    all.whole = run_pieces(work->size(), "certify", control, [work, results, along, stop](std::size_t i) -> KeepResult {
        Cover cover = cover_branch((*work)[i], along, stop);
        return [results, i, cover = std::move(cover)] { (*results)[i] = cover; };
    });
    for (auto& cover : *results) {
        if (!cover) continue;
        all.recorded.push_back(std::move(cover->recorded));
        for (CertifiedBranch& branch : cover->branches) all.branches.push_back(std::move(branch));
    }
    return all;
}

}  // namespace swirl::studies::certify
