#include "apps/studies/certify/proven_branches.hpp"

#include "apps/studies/parallel/pieces.hpp"
#include "map/derivative/parameter.hpp"

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

/// Boxes first … last − 1, of which the stability is not decided, between two of which it is.
std::optional<ProvenChange> change_over(const std::vector<BranchBox>& boxes, std::size_t first, std::size_t last) {
    const BranchBox &before = boxes[first - 1], &after = boxes[last];
    ProvenChange change{"", before.outside, after.outside, before.parameter_end, before.parameter_end};
    const std::size_t parameter = before.middle.size() - 1;
    bool regular = true;  // with the parameter as the running unknown no multiplier is 1
    for (std::size_t i = first; i < last; ++i) {
        change.low = std::min(change.low, boxes[i].parameter_low);
        change.high = std::max(change.high, boxes[i].parameter_high);
        regular = regular && boxes[i].running == parameter;
    }
    const int crossed = std::abs(change.outside_after - change.outside_before);
    const double into = before.parameter_end - before.parameter_begin,
                 out = after.parameter_end - after.parameter_begin;
    if (crossed == 0) return std::nullopt;
    change.kind = crossed == 1 && !regular && into * out < 0 ? "fold"
                  : crossed == 1 && regular                  ? "flip"
                  : crossed == 2 && regular                  ? "neimark-sacker"
                                                             : "change";
    return change;
}

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

/// What one branch of a record gave.
struct Cover {
    RecordedBranch recorded;
    std::vector<CertifiedBranch> branches;
};

Cover cover_branch(RecordedBranch recorded, const ParameterRange& along, const std::function<bool()>& stop) {
    const std::size_t count = recorded.places.size();
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
            on[i] = std::any_of(branch.proof.boxes.begin(), branch.proof.boxes.end(), [&](const BranchBox& box) {
                return lies_in(box, recorded.places[i], *along.parameter);
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
    const auto same = [](const proof::Branch& a, const proof::Branch& b) {
        return a.vertex_step == b.vertex_step && a.mode == b.mode && a.slip == b.slip;
    };
    return std::any_of(others.begin(), others.end(), [&](const CertifiedBranch& other) {
        const auto &a = other.proof.itinerary, &b = branch.proof.itinerary;
        return std::equal(a.begin(), a.end(), b.begin(), b.end(), same) &&
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

std::vector<ProvenChange> CertifiedBranch::changes() const {
    std::vector<ProvenChange> changes;
    const auto& boxes = proof.boxes;
    for (std::size_t i = 1; i < boxes.size(); ++i) {
        if (boxes[i].decided || !boxes[i - 1].decided) continue;
        std::size_t last = i;
        while (last < boxes.size() && !boxes[last].decided) ++last;
        if (last == boxes.size()) break;
        if (const auto change = change_over(boxes, i, last)) changes.push_back(*change);
        i = last;
    }
    return changes;
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
