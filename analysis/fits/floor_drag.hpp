// The drag of a floor that moves on a circle, from how the arcs of a film bend.
#pragma once

#include "analysis/fits/free_arcs.hpp"

#include <Eigen/Core>

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

namespace swirl::analysis {

/// Frames of one arc, first and last included, that are away from the kinks at its ends.
struct ArcPart {
    std::size_t first = 0, last = 0;
};

/// Of arcs with one of these kinks at either end: frames beyond 4 errors of the kinks' times. (Frames next to a kink
/// are on the arc that they lie nearer to, which bends it.) Of `fewest_bent` frames or more. O(arcs).
std::vector<ArcPart> parts_between(const FilmArcs& film, std::span<const Kink> kinks);
inline constexpr std::size_t fewest_bent = 4;

/// Standard errors to either end of an interval at 95 %.
inline constexpr double sure_drag = 1.959964;

struct DragFit {
    double value = nan, error = nan;  ///< γ, in 1/time; NaN with fewer parts than `fewest_parts`
    std::size_t parts = 0;

    /// The interval is above 0.
    bool surely_drags() const { return value > sure_drag * error; }
};

/// γ by least squares over the places of all parts, each with an A and B of its own (variable projection,
/// Gauss–Newton), Tukey's biweight over the parts: an impact that was not seen bends its arc more than noise does. The
/// error is the larger one of that of the noise and that of how the parts scatter. O(frames).
///   frames  in the laboratory, film.kept of straight arcs;   noise  of x or y in one frame
DragFit fit_drag(std::span<const FilmFrame> frames, std::span<const ArcPart> parts, const FloorMotion& floor,
                 double noise);
inline constexpr std::size_t fewest_parts = 8;

/// Which parts of the arcs count.
using PartsOf = std::function<std::vector<ArcPart>(const FilmArcs& arcs)>;

struct DraggedArcs {
    DragFit drag;
    FilmArcs arcs;  ///< with drag.value, or those given where that is NaN
};

/// γ of a film. Arcs under a drag are no straight lines, and straight ones cut them where noise allows it best, so that
/// what is left bends too little: frames are divided anew with the γ that was found (fit_arcs) until it stays.
///   straight  arcs of those frames without a drag
DraggedArcs settled_drag(std::span<const FilmFrame> frames, double period, const FilmArcs& straight,
                         const FloorMotion& floor, const PartsOf& parts_of);

/// What fit_arcs() makes least, for noise (x or y, θ) that is given: two films of the same frames differ by how well
/// their floors describe them. An outlier costs what a line does.
double cost_of(const FilmArcs& film, double place_noise, double angle_noise);

}  // namespace swirl::analysis
