#include "apps/studies/bifurcation_curves/curve_ends.hpp"
#include "apps/studies/bifurcation_curves/curves_of_kind.hpp"
#include "apps/studies/bifurcation_curves/search_equations.hpp"
#include "apps/studies/parallel/pieces.hpp"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace swirl::studies::bifurcation_curves {

/// What the starting points of one round have led to, as pieces find it. Pieces that a stop leaves alone share it.
class Round {
public:
    Round(std::size_t count, ReportDone report) : followed_(count), report_(std::move(report)) {}

    /// Keeps what starting point i has led to, unless the round is over.
    void keep(std::size_t i, Followed followed) {
        const std::lock_guard lock(mutex_);
        if (!report_) return;
        followed_[i] = std::move(followed);
        report_(static_cast<double>(++done_));
    }
    /// Ends the round; none of those that were not finished.
    std::vector<std::optional<Followed>> take() {
        const std::lock_guard lock(mutex_);
        report_ = nullptr;
        return std::exchange(followed_, {});
    }

private:
    std::mutex mutex_;
    std::vector<std::optional<Followed>> followed_;
    ReportDone report_;
    std::size_t done_ = 0;
};

/// Its state. Starting points come in rounds: those of a round are searched by kind, the kinds side by side, and what
/// is found is put in the order of its starting points; where the curves of a round lead is the next. So what is found
/// does not depend on threads.
class CurveSearch::Walk {
public:
    Walk(const Scene<double>& scene, const Plane& plane, const FollowOptions& follow)
        : equations_(std::make_shared<const SearchEquations>(scene, plane, follow)) {}

    std::vector<std::optional<std::size_t>> follow(const std::vector<StartingPoint>& starting_points) {
        const std::size_t first = numbered_;
        auto next = follow_round(starting_points, "curves");
        while (!next.empty() && !control().is_stopped()) next = follow_round(next, "curves that these lead to");
        std::vector<std::optional<std::size_t>> through(starting_points.size());
        for (std::size_t i = 0; i < through.size(); ++i)
            if (const auto curve = through_.find(first + i); curve != through_.end()) through[i] = curve->second;
        return through;
    }

    std::size_t whole_of(std::size_t curve) const {
        for (auto whole = wholes_.find(curve); whole != wholes_.end(); whole = wholes_.find(curve))
            curve = whole->second;
        return curve;
    }

    PlaneCurves result() const {
        PlaneCurves found = result_;
        for (const auto& [number, curve] : curves_) found.curves.push_back(*curve);
        return found;
    }

private:
    using Known = std::shared_ptr<CurvesOfKind>;

    const RunControl& control() const { return equations_->follow.control; }

    /// Where the curves lead that were found.
    std::vector<StartingPoint> follow_round(const std::vector<StartingPoint>& starting_points,
                                            const std::string& task) {
        const std::size_t first = numbered_;
        numbered_ += starting_points.size();
        const auto parts = by_kind(starting_points);
        const auto starts = std::make_shared<const std::vector<StartingPoint>>(starting_points);
        const auto round = std::make_shared<Round>(starting_points.size(),
                                                   control().begin(task, static_cast<double>(starting_points.size())));
        run_pieces(parts.size(), "", control(), [parts, starts, round, first](std::size_t part) -> KeepResult {
            const auto& [known, numbers] = parts[part];
            for (const std::size_t i : numbers) {
                auto followed = known->follow(first + i, (*starts)[i]);
                if (!followed) return {};
                round->keep(i, std::move(*followed));
            }
            return [] {};
        });
        return ends_of_all(keep_curves(first, round->take()));
    }

    /// The starting points' places by kind, those with most of them first.
    std::vector<std::pair<Known, std::vector<std::size_t>>> by_kind(const std::vector<StartingPoint>& starting_points) {
        std::map<CurveKind, std::vector<std::size_t>> places;
        for (std::size_t i = 0; i < starting_points.size(); ++i) {
            if (const auto kind = curve_kind_of(starting_points[i])) {
                places[*kind].push_back(i);
                continue;
            }
            ++result_.starting_points;
            auto& left_out = result_.left_out;
            if (std::find(left_out.begin(), left_out.end(), starting_points[i].kind) == left_out.end())
                left_out.push_back(starting_points[i].kind);
        }
        std::vector<std::pair<Known, std::vector<std::size_t>>> parts;
        for (auto& [kind, numbers] : places) {
            Known& known = known_[kind];
            if (!known) known = std::make_shared<CurvesOfKind>(equations_);
            parts.emplace_back(known, std::move(numbers));
        }
        std::stable_sort(parts.begin(), parts.end(),
                         [](const auto& a, const auto& b) { return a.second.size() > b.second.size(); });
        return parts;
    }

    /// The new curves of a round, in the order of their starting points.
    std::vector<Followed> keep_curves(std::size_t first, std::vector<std::optional<Followed>> round) {
        std::vector<Followed> found;
        for (std::size_t i = 0; i < round.size(); ++i) {
            if (!round[i]) continue;
            ++result_.starting_points;
            if (round[i]->without) ++result_.without;
            if (round[i]->on) through_.emplace(first + i, *round[i]->on);
            if (!round[i]->curve) continue;
            for (const std::size_t part : round[i]->parts) {
                curves_.erase(part);
                wholes_.emplace(part, first + i);
            }
            curves_.emplace(first + i, round[i]->curve);
            found.push_back(std::move(*round[i]));
        }
        return found;
    }

    std::vector<StartingPoint> ends_of_all(std::vector<Followed> curves) {
        const auto shared = std::make_shared<const std::vector<Followed>>(std::move(curves));
        std::vector<std::pair<std::size_t, EndPart>> parts;  // each with its curve
        for (std::size_t c = 0; c < shared->size(); ++c)
            for (const EndPart& part : parts_of_ends((*shared)[c])) parts.emplace_back(c, part);
        std::vector<CurveEnds> ends(parts.size());
        const auto look = [equations = equations_, shared, parts, &ends](std::size_t i) -> KeepResult {
            const auto& [curve, part] = parts[i];
            const auto found = std::make_shared<CurveEnds>(ends_of(*equations, (*shared)[curve], part));
            return [&ends, i, found] { ends[i] = std::move(*found); };
        };
        run_pieces(ends.size(), "", control(), look);
        std::vector<StartingPoint> all;
        for (CurveEnds& end : ends) {
            result_.starting_points += end.not_found;
            result_.without += end.not_found;
            std::move(end.starting_points.begin(), end.starting_points.end(), std::back_inserter(all));
        }
        return all;
    }

    std::shared_ptr<const SearchEquations> equations_;
    std::map<CurveKind, Known> known_;
    std::size_t numbered_ = 0;                                    ///< starting points so far
    std::map<std::size_t, std::shared_ptr<const Curve>> curves_;  ///< by the number of their starting point
    std::map<std::size_t, std::size_t> through_;                  ///< curves of starting points
    std::map<std::size_t, std::size_t> wholes_;                   ///< of curves that are parts those they are parts of
    PlaneCurves result_;                                          ///< but for the curves
};

CurveSearch::CurveSearch(const Scene<double>& scene, const Plane& plane, const FollowOptions& options)
    : walk_(std::make_unique<Walk>(scene, plane, options)) {}

CurveSearch::~CurveSearch() = default;

std::vector<std::optional<std::size_t>> CurveSearch::follow(const std::vector<StartingPoint>& starting_points) {
    return walk_->follow(starting_points);
}

std::size_t CurveSearch::whole_of(std::size_t curve) const {
    return walk_->whole_of(curve);
}

PlaneCurves CurveSearch::found() const {
    return walk_->result();
}

}  // namespace swirl::studies::bifurcation_curves
