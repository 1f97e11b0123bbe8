#include "apps/studies/scene_map/scene_function.hpp"

#include "analysis/threads.hpp"
#include "apps/studies/scene_map/lanes.hpp"
#include "apps/studies/scene_map/scene_map.hpp"
#include "map/orbit/orbit.hpp"
#include "map/orbit/outcome.hpp"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <limits>
#include <stdexcept>

namespace swirl::studies {

namespace {

constexpr std::size_t rows_together = 1024;      // of one task: some 0.1 ms
constexpr std::int64_t steps_between = 100'000;  // of all rows of a task, from look to look: some 10 ms

/// Codes stay what they are as endings are added: those of a floor that drags come after `not_leaving`.
std::uint8_t code_of(Outcome outcome) {
    const auto number = static_cast<std::uint8_t>(outcome);
    return number < not_leaving ? number : static_cast<std::uint8_t>(number + 1);
}

template <int D>
class FunctionOfDimension final : public SceneFunction {
public:
    explicit FunctionOfDimension(const Scene<double>& scene) : map_(scene) {}

    int dimension() const override { return D; }

    void map(std::span<const double> z, std::int64_t steps, int threads, std::span<double> image,
             std::span<std::uint8_t> outcomes, const std::function<bool()>& stop) const override {
        in_tasks(outcomes.size(), threads, stop, [&](std::size_t begin, std::size_t end) {
            const std::size_t count = end - begin;
            map_rows(z.subspan(begin * D, count * D), steps, image.subspan(begin * D, count * D),
                     outcomes.subspan(begin, count), stop);
        });
    }

    void derivative(std::span<const double> z, int threads, std::span<double> image, std::span<double> derivative,
                    std::span<std::uint8_t> outcomes, const std::function<bool()>& stop) const override {
        in_tasks(outcomes.size(), threads, stop, [&](std::size_t begin, std::size_t end) {
            for (std::size_t row = begin; row < end; ++row)
                outcomes[row] = derivative_of_row(z.subspan(row * D, D), image.subspan(row * D, D),
                                                  derivative.subspan(row * D * D, D * D));
        });
    }

private:
    using Map = SceneMap<D>;
    using State = typename Map::State;

    template <class Work>
    static void in_tasks(std::size_t rows, int threads, const std::function<bool()>& stop, const Work& work) {
        if (rows <= rows_together) return work(0, rows);
        analysis::on_threads(threads, [&] {
            using Range = tbb::blocked_range<std::size_t>;
            tbb::parallel_for(Range(0, rows, rows_together), [&](const Range& range) {
                for (std::size_t i = range.begin(); i < range.end() && !stop(); i += rows_together)
                    work(i, std::min(i + rows_together, range.end()));
            });
        });
    }

    static analysis::Vector<D> row_of(std::span<const double> z) { return analysis::Vector<D>(z.data()); }
    static void put(const State& state, std::span<double> row) {
        const analysis::Vector<D> point = Map::coordinates(state);
        std::copy(point.begin(), point.end(), row.begin());
    }
    static void put_nothing(std::span<double> row) {
        std::fill(row.begin(), row.end(), std::numeric_limits<double>::quiet_NaN());
    }

    bool is_leaving(std::span<const double> z) const {
        try {
            require_leaving(map_.body(), section_point_of(row_of(z)));
            return true;
        } catch (const std::invalid_argument&) {
            return false;
        }
    }

    /// What stands for the outcome of a step from which no orbit goes on.
    Outcome ending_of(const ReturnStep<double>& step) const {
        if (step.outcome != Outcome::completed) return step.outcome;
        return has_diverged(map_.body(), step.collision.after) ? Outcome::diverged : Outcome::resting;
    }

    /// An image is that of the last step: whether another may follow is the next one's business.
    Outcome follow_alone(State& z, std::int64_t steps, const std::function<bool()>& stop) const {
        ReturnStep<double> step;
        for (std::int64_t i = 0; i < steps; ++i) {
            if (i % steps_between == 0 && stop()) return Outcome::unresolved;
            step = map_.return_step(z);
            if (step.outcome != Outcome::completed) return step.outcome;
            z = step.collision.after;
            if (i + 1 < steps && !map_.goes_on(step)) return ending_of(step);
        }
        return Outcome::completed;
    }

    void map_rows(std::span<const double> z, std::int64_t steps, std::span<double> image,
                  std::span<std::uint8_t> outcomes, const std::function<bool()>& stop) const {
        const std::size_t rows = outcomes.size();
        if (rows < fewest_together || !has_lanes()) {
            for (std::size_t row = 0; row < rows; ++row)
                outcomes[row] = map_alone(z.subspan(row * D, D), steps, image.subspan(row * D, D), stop);
            return;
        }
        std::vector<LaneOrbit<D>> orbits;
        std::vector<std::size_t> rows_of_orbits;
        for (std::size_t row = 0; row < rows; ++row) {
            const auto own = z.subspan(row * D, D);
            if (is_leaving(own)) {
                orbits.push_back(map_.lane_orbit(Map::state_at(row_of(own)), 0));
                rows_of_orbits.push_back(row);
                continue;
            }
            outcomes[row] = not_leaving;
            put_nothing(image.subspan(row * D, D));
        }
        follow_together(orbits, steps, stop);
        for (std::size_t i = 0; i < orbits.size(); ++i) {
            const std::size_t row = rows_of_orbits[i];
            State& end = orbits[i].z;
            // `count` is what is left: of an orbit that went on alone, or ended.
            const Outcome outcome = follow_alone(end, orbits[i].count, stop);
            outcomes[row] = code_of(outcome);
            outcome == Outcome::completed ? put(end, image.subspan(row * D, D))
                                          : put_nothing(image.subspan(row * D, D));
        }
    }

    /// As many steps as all of them can take together; `count` is then what is left of each.
    void follow_together(std::vector<LaneOrbit<D>>& orbits, std::int64_t steps,
                         const std::function<bool()>& stop) const {
        std::vector<std::int64_t> left(orbits.size(), steps);
        const std::int64_t each = steps_between / static_cast<std::int64_t>(rows_together);
        for (std::int64_t done = 0, count = 0; done < steps && !stop(); done += count) {
            std::vector<LaneOrbit<D>> going;
            std::vector<std::size_t> places;
            count = std::min(each, steps - done);
            for (std::size_t i = 0; i < orbits.size(); ++i) {
                if (left[i] != steps - done) continue;
                going.push_back(map_.lane_orbit(orbits[i].z, count));
                places.push_back(i);
            }
            if (going.size() < fewest_together) break;
            map_.follow_together(going);
            for (std::size_t k = 0; k < going.size(); ++k) {
                if (!going[k].taken) continue;
                orbits[places[k]].z = going[k].z;
                left[places[k]] -= count;
            }
        }
        for (std::size_t i = 0; i < orbits.size(); ++i) orbits[i].count = left[i];
    }

    std::uint8_t map_alone(std::span<const double> z, std::int64_t steps, std::span<double> image,
                           const std::function<bool()>& stop) const {
        if (!is_leaving(z)) {
            put_nothing(image);
            return not_leaving;
        }
        State state = Map::state_at(row_of(z));
        const Outcome outcome = follow_alone(state, steps, stop);
        outcome == Outcome::completed ? put(state, image) : put_nothing(image);
        return code_of(outcome);
    }

    std::uint8_t derivative_of_row(std::span<const double> z, std::span<double> image,
                                   std::span<double> derivative) const {
        put_nothing(image);
        put_nothing(derivative);
        if (!is_leaving(z)) return not_leaving;
        const State state = Map::state_at(row_of(z));
        const ReturnStep<double> step = map_.return_step(state);
        if (step.outcome != Outcome::completed) return code_of(step.outcome);
        put(step.collision.after, image);
        const analysis::Matrix<D> by_column =
            step.contacts.empty() ? map_.through_flight(state, step) : map_.through_contact(section_point(state), step);
        for (int i = 0; i < D; ++i)
            for (int j = 0; j < D; ++j) derivative[static_cast<std::size_t>(i * D + j)] = by_column(i, j);
        return code_of(Outcome::completed);
    }

    Map map_;
};

}  // namespace

std::vector<std::string_view> outcome_names() {
    std::vector<std::string_view> names;
    for (int number = 0; number <= static_cast<int>(Outcome::contact_over_dry_floor); ++number) {
        if (number == not_leaving) names.push_back("not-leaving");
        names.push_back(name_of(static_cast<Outcome>(number)));
    }
    return names;
}

std::unique_ptr<SceneFunction> function_of(const Scene<double>& scene) {
    if (scene.is_disk()) return std::make_unique<FunctionOfDimension<disk_dimension>>(scene);
    return std::make_unique<FunctionOfDimension<polygon_dimension>>(scene);
}

}  // namespace swirl::studies
