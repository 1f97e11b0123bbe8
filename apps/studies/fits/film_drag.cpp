#include "apps/studies/fits/film_drag.hpp"

#include "apps/studies/fits/film_impacts.hpp"
#include "map/model/scene.hpp"

#include <cmath>
#include <cstddef>
#include <vector>

namespace swirl::studies {

namespace {

using analysis::ArcPart;
using analysis::FilmArcs;
using Frames = std::span<const analysis::FilmFrame>;

/// Between its ends the arc comes to the wall so nearly that it may have met it unseen.
bool comes_near(const FilmArcs& film, Frames frames, const ArcPart& part, const FilmedScene& scene,
                const DishMotion& dish) {
    constexpr double near = 8;  // standard errors of three frames' mean
    const double turned = scene.sides == disk_sides ? 0 : scene.alpha * film.angle_noise;
    const double error = std::hypot(film.place_noise, turned) / std::sqrt(3.0);
    const auto gap_at = [&](std::size_t i) {
        const Eigen::Vector3d mean = (frames[i - 1].place + frames[i].place + frames[i + 1].place) / 3;
        return contact_at(scene, dish, frames[i].time, mean).gap;
    };
    double before = gap_at(part.first + 1), here = before;
    for (std::size_t i = part.first + 1; i + 1 < part.last; ++i) {
        const double after = gap_at(i + 1);
        if (here >= before && here >= after && here > -near * error) return true;
        before = here, here = after;
    }
    return false;
}

}  // namespace

analysis::DragFit film_drag(Frames frames, double period, const FilmArcs& arcs, const FilmedScene& scene,
                            const DishMotion& dish) {
    const auto parts_of = [&](const FilmArcs& film, Frames kept) {
        std::vector<analysis::Kink> kinks;
        for (const analysis::Kink& kink : analysis::kinks_of(film))
            if (lines_meet(kink)) kinks.push_back(kink);
        std::vector<ArcPart> parts = analysis::parts_between(film, kinks);
        std::erase_if(parts, [&](const ArcPart& part) { return comes_near(film, kept, part, scene, dish); });
        return parts;
    };
    return analysis::settled_drag(frames, period, arcs, {scene.beta, dish.rate, dish.phase}, parts_of);
}

}  // namespace swirl::studies
